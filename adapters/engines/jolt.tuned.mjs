// Jolt's simulation without the overlap that it leaves alone, and with impacts at any speed:
//     touchstone adapter check "exec:node adapters/engines/jolt.tuned.mjs"
import { serveMotion } from "./jolt_motion.mjs";

serveMotion("jolt.tuned", { slop: 0, threshold: 0 }, "mPenetrationSlop 0, mMinVelocityForRestitution 0");
