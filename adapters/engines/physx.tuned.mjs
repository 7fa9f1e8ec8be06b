// PhysX's simulation with impacts at any speed, and more iterations of its solver:
//     touchstone adapter check "exec:node adapters/engines/physx.tuned.mjs"
import { serveMotion } from "./physx_motion.mjs";

serveMotion("physx.tuned", { threshold: 0, iterations: [32, 4] }, ["impulse", "simulation"],
  "bounceThresholdVelocity 0, 32 iterations of positions and 4 of velocities");
