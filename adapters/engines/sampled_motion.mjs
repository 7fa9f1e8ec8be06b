// What the simulations of the engines have in common: sample times, and forces that begin and change between them.
import { Abstain } from "../js/touchstone_adapter.mjs";

/** s, at most; as native engines: what the judge grants to a body on a face is that of steps of at most 1/256 s. */
export const step = 1 / 256;

/** The force on a body from `time` on. */
export const forceAt = (forces, body, time) => forces.findLast((f) => f.body === body && f.time <= time)?.force_W
  ?? [0, 0, 0];

/** Requires that all bodies start at once. */
export function requireOneStart({ start_times = [] }) {
  if (start_times.some((t) => t > 0)) throw new Abstain("all bodies start at once");
}

const isFixed = ({ mass }) => mass?.type === "fixed";
const isBall = ({ shape, mass }) => shape.type === "sphere" && (mass?.p_BBcm ?? []).every((x) => x === 0);
const ballOrFixed = (body) => isBall(body) || isFixed(body);

/** The laws of restitution agree on these bodies' impacts: where one bounces, it is without friction or of balls. */
function lawsAgree(A, B) {
  const least = (coefficient) => Math.min(A.material?.[coefficient] ?? 0, B.material?.[coefficient] ?? 0);
  return least("restitution") === 0 || least("friction") === 0 || (ballOrFixed(A) && ballOrFixed(B));
}

/** Requires that the bodies start at once, with restitution by Newton's law and finite friction. */
export function requireOffered({ bodies, motion }) {
  requireOneStart(motion);
  if (bodies.some(({ material }) => material?.friction === "sticking")) throw new Abstain("no infinite friction");
  const agree = bodies.every((A, i) => bodies.slice(0, i).every((B) => lawsAgree(A, B)));
  if (motion.law !== "newton" && !agree) throw new Abstain("restitution is by Newton's law");
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
