// Bodies of cannon-es for those of a scene, and what the engine says of them at rest.
import { readFileSync } from "node:fs";
import { Abstain, inWorld, scaled, unitQuaternion } from "../js/touchstone_adapter.mjs";

export const CANNON = await import("cannon-es");

const installed = new URL("node_modules/cannon-es/package.json", import.meta.url);
export const version = JSON.parse(readFileSync(installed)).version;

export const vector = (v) => new CANNON.Vec3(...v);
export const quaternion = (q) => (({ w, x, y, z }) => new CANNON.Quaternion(x, y, z, w))(unitQuaternion(q));
export const list = ({ x, y, z }) => [x, y, z];

function shapeOf(shape) {
  if (shape.type === "sphere") return new CANNON.Sphere(shape.radius);
  if (shape.type === "box") return new CANNON.Box(vector(shape.half_extents));
  if (!shape.faces) throw new Abstain("a hull needs its faces");
  return new CANNON.ConvexPolyhedron({ vertices: shape.vertices.map(vector), faces: shape.faces });
}

/** A shape that is no compound is its only part. */
export const partsOf = (shape) => (shape.type === "compound" ? shape.parts
  : [{ shape, X_BP: { p: [0, 0, 0], q: { w: 1, x: 0, y: 0, z: 0 } } }]);

/** The shapes of a body in cannon's frame, which has its origin at the centre of mass p_BBcm. */
function addShapes(rigid, shape, p_BBcm) {
  for (const { shape: part, X_BP: { p, q } } of partsOf(shape)) {
    rigid.addShape(shapeOf(part), vector(p.map((x, i) => x - p_BBcm[i])), quaternion(q));
  }
}

const isRound = ({ type }) => type === "sphere" || type === "box";

/** cannon-es computes neither the centre of mass nor the volume of a hull, so these must be given. */
export function massProperties({ shape, mass = { type: "density", density: 1 } }) {
  if (mass.type === "given") return mass;
  if (!isRound(shape)) throw new Abstain("the engine does not compute the mass of a hull or of a compound");
  const of = shapeOf(shape), m = mass.density * of.volume();
  const [x, y, z] = list(of.calculateLocalInertia(m));
  return { mass: m, p_BBcm: [0, 0, 0], I_BBcm_B: [[x, 0, 0], [0, y, 0], [0, 0, z]] };
}

/** A body of the engine; a fixed one is kinematic and keeps its velocity. */
export function bodyOf(body) {
  const { v_WBcm = [0, 0, 0], w_WB = [0, 0, 0] } = body.velocity ?? {};
  const fixed = body.mass?.type === "fixed";
  const { mass, p_BBcm, I_BBcm_B: I } = fixed ? { mass: 0, p_BBcm: [0, 0, 0] } : massProperties(body);
  if (I?.some((row, i) => row.some((x, j) => i !== j && x !== 0))) throw new Abstain("an inertia that is not diagonal");
  const rigid = new CANNON.Body({
    mass, type: fixed ? CANNON.Body.KINEMATIC : CANNON.Body.DYNAMIC, linearDamping: 0, angularDamping: 0,
    position: vector(inWorld(body.X_WB, p_BBcm)), quaternion: quaternion(body.X_WB.q),
    velocity: vector(v_WBcm), angularVelocity: vector(w_WB), material: new CANNON.Material(),
  });
  addShapes(rigid, body.shape, p_BBcm);
  if (I) {
    rigid.inertia.set(I[0][0], I[1][1], I[2][2]);
    rigid.invInertia.set(1 / I[0][0], 1 / I[1][1], 1 / I[2][2]);
    rigid.updateInertiaWorld(true);
  }
  return { rigid, p_BBcm };
}

/** The pose of the body's frame B. */
export function poseOf({ rigid, p_BBcm }) {
  const { x, y, z, w } = rigid.quaternion;
  return { p: inWorld({ p: list(rigid.position), q: { w, x, y, z } }, scaled(-1, p_BBcm)), q: { w, x, y, z } };
}

export const mass = (scene) => scene.bodies.map((body) => {
  if (body.mass?.type === "fixed") return null;
  const { mass: m, p_BBcm, I_BBcm_B } = massProperties(body);
  return { mass: m, p_BBcm, I_BBcm_B };
});

export const bounds = (scene) => scene.bodies.map((body) => {
  const { rigid } = bodyOf({ ...body, mass: { type: "fixed" } });
  rigid.updateAABB();
  return { lo: list(rigid.aabb.lowerBound), hi: list(rigid.aabb.upperBound) };
});
