// An adapter of cannon-es for Touchstone, with some contactEquationRelaxation: cannon.mjs has the shipped one.
import { serve } from "../js/touchstone_adapter.mjs";
import { bounds, mass, version } from "./cannon_bodies.mjs";
import { simulationWith } from "./cannon_motion.mjs";
import * as snippets from "./cannon_snippets.mjs";
import { step } from "./sampled_motion.mjs";

/** `settings`: in words, for the card. */
export function serveCannon(name, relaxation, settings) {
  const card = {
    name, version, precision: "binary64",
    about: "Body.updateAABB; Shape.volume and calculateLocalInertia of balls and boxes; World.step, equal steps of at "
      + `most 1/256 s between sample times, without damping, e and mu of a pair the lesser, ${settings}`,
    homepage: "https://github.com/pmndrs/cannon-es",
    // It states none: the customary one.
    domain: { lengths: [1e-6, 1e9], reach: 1e9, speed: 3e8, angular_speed: 1e6, lowest_speed: 1e-6 },
    stepping: { step, order: 1 },
  };
  serve(card, { mass, bounds, simulation: simulationWith(relaxation) }, snippets);
}
