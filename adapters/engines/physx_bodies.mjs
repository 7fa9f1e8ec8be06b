// PhysX's geometries for those of a scene. The package is built for the web alone, so it must see a window and no Node.js
// while it loads. An object made with `new` is destroyed by hand.
import { readFileSync } from "node:fs";
import { Abstain, Refused, scaled, unitQuaternion } from "../js/touchstone_adapter.mjs";

const { process } = globalThis;
const folder = new URL("node_modules/physx-js-webidl/", import.meta.url);
const wasmBinary = readFileSync(new URL("physx-js-webidl.wasm", folder));
globalThis.process = undefined;
globalThis.window = {};
const { default: initPhysX } = await import("physx-js-webidl");
export const PX = await initPhysX({ wasmBinary });
delete globalThis.window;
globalThis.process = process;

export const top = PX.PxTopLevelFunctions.prototype; // where the binding puts static functions
const { description } = JSON.parse(readFileSync(new URL("package.json", folder)));
export const version = description.match(/[\d.]+$/)[0];

export const scale = new PX.PxTolerancesScale();
const foundation = top.CreateFoundation(top.PHYSICS_VERSION, new PX.PxDefaultAllocator(), new PX.PxDefaultErrorCallback());
export const physics = top.CreatePhysics(top.PHYSICS_VERSION, foundation, scale);
const cooking = new PX.PxCookingParams(scale);
cooking.planeTolerance = 0; // as shipped faces within 0.07 % of a hull's size are one
const flags = new PX.PxConvexFlags(PX.PxConvexFlagEnum.eCOMPUTE_CONVEX);

// For the cards; the reasons: docs/how_to/add_a_subject.md.
export const homepage = "https://github.com/NVIDIA-Omniverse/PhysX";
export const domain = { lengths: [0.02, 100], reach: 1000 };

/** Calls `use` with a value that is destroyed afterwards. */
export function using(value, use) {
  try {
    return use(value);
  } finally {
    PX.destroy(value);
  }
}

export const vector = (v) => new PX.PxVec3(...v);
export const list = ({ x, y, z }) => [x, y, z];

function meshOf({ vertices }) {
  const points = new PX.PxArray_PxVec3(vertices.length);
  vertices.forEach((v, i) => using(vector(v), (point) => points.set(i, point)));
  const desc = new PX.PxConvexMeshDesc();
  desc.flags = flags;
  desc.points.count = vertices.length;
  desc.points.stride = 12;
  desc.points.data = points.begin();
  const mesh = top.CreateConvexMesh(cooking, desc);
  PX.destroy(desc);
  PX.destroy(points);
  if (!mesh || mesh.ptr === 0) throw new Refused("PxCreateConvexMesh returns null");
  return mesh;
}

/** Calls `use` with the geometry of a convex shape. */
export function withGeometry(shape, use) {
  if (shape.type === "compound") throw new Abstain("the queries are about one convex shape each");
  if (shape.type === "sphere") return using(new PX.PxSphereGeometry(shape.radius), use);
  if (shape.type === "box") return using(new PX.PxBoxGeometry(...shape.half_extents), use);
  const mesh = meshOf(shape);
  try {
    return using(new PX.PxConvexMeshGeometry(mesh), use);
  } finally {
    mesh.release();
  }
}

/** Calls `use` with the pose. */
export const withPose = ({ p, q }, use) => using(vector(p), (at) => {
  const { w, x, y, z } = unitQuaternion(q);
  return using(new PX.PxQuat(x, y, z, w), (turn) => using(new PX.PxTransform(at, turn), use));
});

/** The mass properties that PhysX computes for a body with a density. */
export const massOf = ({ shape, mass }) => withGeometry(shape, (geometry) =>
  using(new PX.PxMassProperties(geometry), (unit) => {
    const density = mass?.density ?? 1;
    return { mass: density * unit.mass, p_BBcm: list(unit.centerOfMass),
      I_BBcm_B: ["column0", "column1", "column2"].map((k) => scaled(density, list(unit.inertiaTensor[k]))) };
  }));
