// An adapter of Rapier 3D for Touchstone: `npm ci` in this folder, then
//     touchstone adapter check "exec:node adapters/engines/rapier.mjs"
import { serve, unitQuaternion } from "../js/touchstone_adapter.mjs";
import * as snippets from "./rapier_snippets.mjs";
import { convexCollider, domain, homepage, list, massOf, vector, version } from "./rapier_bodies.mjs";
import { simulation } from "./rapier_motion.mjs";
import { step } from "./sampled_motion.mjs";
import { met, straightCast } from "./straight_cast.mjs";

const card = {
  name: "rapier", version, precision: "binary32",
  about: "Shape.contactShape; Shape.castShape of bodies that do not turn, stopAtPenetration false; mass, localCom and "
    + "principalInertia of a rigid body with one collider; World.step, equal steps of at most 1/256 s between sample "
    + "times, without sleep, e and mu of a pair the lesser",
  homepage, domain, // the reasons: docs/how_to/add_a_subject.md
  stepping: { step, order: 1 },
  dynamics: { speed_limits: { linear: 400, angular: Math.PI / 4 / step } }, // an eighth of a turn a step
  distance_tolerance: { absolute: 100 * 2 ** -23, relative: Math.sqrt(10 * 2 ** -23) },
};

// The closest points of A and B in the world, or the deepest: the distance is negative if they overlap.
function contact(scene) {
  const [A, B] = scene.bodies;
  const [a, b] = [A, B].map((body) => [convexCollider(body).shape, vector(body.X_WB.p), unitQuaternion(body.X_WB.q)]);
  const found = a[0].contactShape(a[1], a[2], ...b, 3.4e38);
  if (!found) throw new Error("contactShape returns null");
  return found;
}

function distance(scene) {
  const found = contact(scene);
  if (found.distance < 0) return { verdict: "overlapping", distance: 0 };
  return { verdict: "separated", distance: found.distance, p_WCa: list(found.point1), p_WCb: list(found.point2) };
}

function penetration(scene) {
  const found = contact(scene);
  if (found.distance >= 0) return { verdict: "separated", depth: 0 };
  return { verdict: "overlapping", depth: -found.distance, nhat_BA_W: list(found.normal2) };
}

function mass(scene) {
  return scene.bodies.map((body) => {
    if (body.mass?.type === "fixed") return null;
    if (body.mass?.type === "given") return { ...body.mass, type: undefined };
    return massOf(body);
  });
}

function time_of_impact(scene) {
  const { end, v_A, v_B } = straightCast(scene), at = ({ X_WB: { p, q } }) => [vector(p), unitQuaternion(q)];
  const [A, B] = scene.bodies, [a, b] = [A, B].map((body) => convexCollider(body).shape);
  const hit = a.castShape(...at(A), vector(v_A), b, ...at(B), vector(v_B), 0, end, false);
  return met(hit ? hit.time_of_impact : null);
}

serve(card, { mass, distance, penetration, time_of_impact, simulation }, snippets);
