// cannon-es as shipped; `./touchstone engines`, or `npm ci` in this folder, installs it. Bodies that overlap are pushed
// apart within some 3 steps, which adds to their speed: a ball with e = 0 leaves the floor with a quarter of its speed.
import { serveCannon } from "./cannon_adapter.mjs";

serveCannon("cannon", 3, "all else as shipped");
