// Jolt's simulation as shipped:
//     touchstone adapter check "exec:node adapters/engines/jolt.simulation.mjs"
import { serveMotion } from "./jolt_motion.mjs";

serveMotion("jolt.simulation", { slop: 0.02, threshold: 1 }, "all else as shipped");
