// An adapter of NAME for Touchstone. Run it by
//     touchstone adapter check "exec:node NAME.mjs"
// It answers the distance of two balls, and abstains from all else. Replace the parts that are marked TODO.
import { Abstain, add, inWorld, norm, rotated, scaled, serve, sub, unitQuaternion } from "./touchstone_adapter.mjs";
// Import the engine below this line. A promise (`await ENGINE.init()`) may be awaited here.

// TODO: the name and version of your engine; "binary32" if it computes in floats; which settings you use.
const card = { name: "NAME", version: "0", precision: "binary64", about: "closed form; a skeleton" };

// TODO: make your engine's shape of the body's. Mind what your engine calls radius, half extents and sides:
// {type: "sphere", radius}, {type: "box", half_extents}: a box has the sides 2 hx, 2 hy, 2 hz;
// {type: "polytope", vertices, faces}: its faces are counter-clockwise seen from outside.
function shapeOf(body) {
  if (body.shape.type !== "sphere") throw new Abstain("balls only");
  return body.shape.radius;
}

// The distance of bodies 0 (A) and 1 (B). A pose X_WB maps points of the body's frame B to the world's frame W:
// p_WQ = R(q) p_BQ + p. q = {w, x, y, z} may have any length but 0; unitQuaternion(q) has length 1.
function distance(scene) {
  const [A, B] = scene.bodies;
  const r_A = shapeOf(A);
  const r_B = shapeOf(B);
  // TODO: ask your engine here. Do not repair its answer: no clamping, no epsilon, no second try.
  const between = sub(A.X_WB.p, B.X_WB.p);
  const gap = norm(between) - r_A - r_B;
  if (gap <= 0) return { verdict: "overlapping", distance: 0 };
  const nhat_BA_W = scaled(1 / norm(between), between); // all positions and directions of answers are in the world's frame
  const p_WCa = sub(A.X_WB.p, scaled(r_A, nhat_BA_W)); // witness on A: a member that you do not know is left out
  const p_WCb = add(B.X_WB.p, scaled(r_B, nhat_BA_W));
  return { verdict: "separated", distance: gap, p_WCa, p_WCb };
}

// TODO: a function for each query that your engine answers: mass, bounds, broad_phase, pair_history, distance,
// penetration, impulse, pixel, time_of_impact, simulation, constraint. Queries that are not here are never asked.
serve(card, { distance });
