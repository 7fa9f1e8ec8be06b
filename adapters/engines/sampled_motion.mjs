// What the simulations of the engines have in common: sample times, and forces that begin and change between them.
import { Abstain } from "../js/touchstone_adapter.mjs";

/** The force on a body from `time` on. */
export const forceAt = (forces, body, time) => forces.findLast((f) => f.body === body && f.time <= time)?.force_W
  ?? [0, 0, 0];

/** Requires that all bodies start at once. */
export function requireOneStart({ start_times = [] }) {
  if (start_times.some((t) => t > 0)) throw new Abstain("all bodies start at once");
}

/** `go(from, to)` moves the bodies on; no force changes in between. `states()` returns what is sampled. */
export function sampled({ sample_times, forces = [] }, go, states) {
  let now = 0;
  return sample_times.map((sample) => {
    for (const time of [...forces.map((f) => f.time).filter((t) => now < t && t < sample), sample]) {
      if (time > now) go(now, time);
      now = time;
    }
    return states();
  });
}
