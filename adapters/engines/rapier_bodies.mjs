// What Rapier's queries and its simulation share: the engine, its vectors, and colliders of shapes.
import { readFileSync } from "node:fs";
import { Abstain, rotated } from "../js/touchstone_adapter.mjs";

export const { default: RAPIER } = await import("@dimforge/rapier3d-compat");
await RAPIER.init();

const installed = new URL("node_modules/@dimforge/rapier3d-compat/package.json", import.meta.url);
export const version = JSON.parse(readFileSync(installed)).version;

export const homepage = "https://rapier.rs";
export const domain = { lengths: [(10 * 2 ** -23) ** 0.25, 100], reach: 100, aspect: 1000 };

export const vector = ([x, y, z]) => ({ x, y, z });
export const list = ({ x, y, z }) => [x, y, z];

/** A collider description of a convex shape. */
export function colliderOf(shape) {
  if (shape.type === "sphere") return RAPIER.ColliderDesc.ball(shape.radius);
  if (shape.type === "box") return RAPIER.ColliderDesc.cuboid(...shape.half_extents);
  const hull = RAPIER.ColliderDesc.convexHull(Float32Array.from(shape.vertices.flat()));
  if (!hull) throw new Error("ColliderDesc.convexHull returns null");
  return hull;
}

export function convexCollider({ shape }) {
  if (shape.type === "compound") throw new Abstain("the queries are about one convex shape each");
  return colliderOf(shape);
}

// Rapier gives the principal moments and their axes F in the body: I = F diag(moments) Fᵀ.
export function massOf(body) {
  const world = new RAPIER.World(vector([0, 0, 0]));
  try {
    const rigid = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic());
    world.createCollider(convexCollider(body).setDensity(body.mass?.density ?? 1), rigid);
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
