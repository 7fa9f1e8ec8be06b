// What Rapier's queries and its simulation share: the engine, its vectors, and colliders of shapes.
import { readFileSync } from "node:fs";

export const { default: RAPIER } = await import("@dimforge/rapier3d-compat");
await RAPIER.init();

const installed = new URL("node_modules/@dimforge/rapier3d-compat/package.json", import.meta.url);
export const version = JSON.parse(readFileSync(installed)).version;

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
