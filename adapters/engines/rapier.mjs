// An adapter of Rapier 3D for Touchstone: `npm ci` in this folder, then
//     touchstone adapter check "exec:node adapters/engines/rapier.mjs"
import { Abstain, rotated, serve, unitQuaternion } from "../js/touchstone_adapter.mjs";
import * as snippets from "./rapier_snippets.mjs";
import { readFileSync } from "node:fs";

const { default: RAPIER } = await import("@dimforge/rapier3d-compat");
await RAPIER.init();
const installed = new URL("node_modules/@dimforge/rapier3d-compat/package.json", import.meta.url);

const card = {
  name: "rapier", version: JSON.parse(readFileSync(installed)).version, precision: "binary32",
  about: "Shape.contactShape; mass, localCom and principalInertia of a rigid body with one collider",
  homepage: "https://rapier.rs",
  // The reasons: docs/how_to/add_a_subject.md.
  domain: { lengths: [(10 * 2 ** -23) ** 0.25, 100], reach: 100, aspect: 1000 },
  distance_tolerance: { absolute: 100 * 2 ** -23, relative: Math.sqrt(10 * 2 ** -23) },
};

const vector = ([x, y, z]) => ({ x, y, z });
const list = ({ x, y, z }) => [x, y, z];

function colliderOf({ shape }) {
  if (shape.type === "sphere") return RAPIER.ColliderDesc.ball(shape.radius);
  if (shape.type === "box") return RAPIER.ColliderDesc.cuboid(...shape.half_extents);
  if (shape.type === "compound") throw new Abstain("the shape queries are about one convex shape each");
  const hull = RAPIER.ColliderDesc.convexHull(Float32Array.from(shape.vertices.flat()));
  if (!hull) throw new Error("ColliderDesc.convexHull returns null");
  return hull;
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

serve(card, { mass, distance, penetration }, snippets);
