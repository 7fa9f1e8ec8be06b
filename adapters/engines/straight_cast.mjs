// First contacts as engines' casts know them: one shape moves along a straight line, and neither turns.
import { Abstain, scaled, sub } from "../js/touchstone_adapter.mjs";
import { requireOneStart } from "./sampled_motion.mjs";

const still = (v = [0, 0, 0]) => v.every((x) => x === 0);

/** The end of the motion (s), the velocities of A and B (m/s), and the way of A seen from B until the end (m). */
export function straightCast({ bodies, motion, gravity }) {
  requireOneStart(motion);
  const [A, B] = bodies.map((body) => body.mass?.type === "fixed"); // gravity moves both bodies, or neither, alike
  if (motion.forces?.length || (A !== B && !still(gravity))) throw new Abstain("casts are along straight lines");
  if (!bodies.every(({ velocity }) => still(velocity?.w_WB))) throw new Abstain("casts do not turn");
  const end = motion.sample_times.at(-1), [v_A, v_B] = bodies.map(({ velocity }) => velocity?.v_WBcm ?? [0, 0, 0]);
  return { end, v_A, v_B, way: scaled(end, sub(v_A, v_B)) };
}

/** The answer for the time of a hit, or for none (null). */
export const met = (time) => (time === null ? { status: "miss" } : { status: "hit", time });
