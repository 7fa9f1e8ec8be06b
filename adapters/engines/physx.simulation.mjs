// PhysX's simulation as shipped:
//     touchstone adapter check "exec:node adapters/engines/physx.simulation.mjs"
import { serveMotion } from "./physx_motion.mjs";

serveMotion("physx.simulation", { threshold: 2, iterations: [4, 1] }, ["simulation"], "all else as shipped");
