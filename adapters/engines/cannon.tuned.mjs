// cannon-es with a relaxation of 1,000 steps, so that pushing bodies apart adds less than 0.1 % to their speed.
//     touchstone adapter check "exec:node adapters/engines/cannon.tuned.mjs"
import { serveCannon } from "./cannon_adapter.mjs";

serveCannon("cannon.tuned", 1000, "contactEquationRelaxation 1000, all else as shipped");
