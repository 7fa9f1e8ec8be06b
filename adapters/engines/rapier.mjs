// An adapter of Rapier 3D for Touchstone: `npm ci` in this folder, then
//     touchstone adapter check "exec:node adapters/engines/rapier.mjs"
import { Abstain, rotated, serve, unitQuaternion } from "../js/touchstone_adapter.mjs";
import * as snippets from "./rapier_snippets.mjs";
import { RAPIER, colliderOf as collider, list, vector, version } from "./rapier_bodies.mjs";
import { simulation, step } from "./rapier_motion.mjs";

const card = {
  name: "rapier", version, precision: "binary32",
  about: "Shape.contactShape; mass, localCom and principalInertia of a rigid body with one collider; World.step, equal "
    + "steps of at most 1/60 s between sample times, without sleep, e and mu of a pair the lesser",
  homepage: "https://rapier.rs",
  // The reasons: docs/how_to/add_a_subject.md.
  domain: { lengths: [(10 * 2 ** -23) ** 0.25, 100], reach: 100, aspect: 1000 },
  stepping: { step, order: 1 },
  distance_tolerance: { absolute: 100 * 2 ** -23, relative: Math.sqrt(10 * 2 ** -23) },
};

function colliderOf({ shape }) {
  if (shape.type === "compound") throw new Abstain("the queries are about one convex shape each");
  return collider(shape);
}

// The closest points of A and B in the world, or the deepest: the distance is negative if they overlap.
function contact(scene) {
  const [A, B] = scene.bodies;
  const [a, b] = [A, B].map((body) => [colliderOf(body).shape, vector(body.X_WB.p), unitQuaternion(body.X_WB.q)]);
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

// Rapier gives the principal moments and their axes F in the body: I = F diag(moments) Fᵀ.
function massOf(body) {
  const world = new RAPIER.World(vector([0, 0, 0]));
  try {
    const rigid = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic());
    world.createCollider(colliderOf(body).setDensity(body.mass?.density ?? 1), rigid);
    rigid.recomputeMassPropertiesFromColliders();
    const [moments, frame] = [list(rigid.principalInertia()), rigid.principalInertiaLocalFrame()];
    const F = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((axis) => rotated(frame, axis));
    const entry = (i, j) => moments.reduce((sum, moment, k) => sum + moment * F[k][i] * F[k][j], 0);
    const I_BBcm_B = [0, 1, 2].map((i) => [0, 1, 2].map((j) => entry(i, j)));
    return { mass: rigid.mass(), p_BBcm: list(rigid.localCom()), I_BBcm_B };
  } finally {
    world.free();
  }
}

function mass(scene) {
  return scene.bodies.map((body) => {
    if (body.mass?.type === "fixed") return null;
    if (body.mass?.type === "given") return { ...body.mass, type: undefined };
    return massOf(body);
  });
}

serve(card, { mass, distance, penetration, simulation }, snippets);
