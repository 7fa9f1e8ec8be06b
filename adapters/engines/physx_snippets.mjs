// Programs in PhysX's own API for the adapter's queries: each asks what the adapter asks, and prints what PhysX says. They
// run where physx-js-webidl is installed: `node --input-type=module < snippet`.
import { norm, scaled, unitQuaternion } from "../js/touchstone_adapter.mjs";
import { straightCast } from "./straight_cast.mjs";

// The package is built for the web alone.
const head = `import { readFileSync } from "node:fs";
const file = "node_modules/physx-js-webidl/physx-js-webidl.wasm", wasmBinary = readFileSync(file);
const { process } = globalThis;
globalThis.process = undefined;
globalThis.window = {};
const { default: initPhysX } = await import("physx-js-webidl");
const PX = await initPhysX({ wasmBinary });
globalThis.process = process;
const top = PX.PxTopLevelFunctions.prototype, scale = new PX.PxTolerancesScale();
const allocator = new PX.PxDefaultAllocator(), errors = new PX.PxDefaultErrorCallback();
const foundation = top.CreateFoundation(top.PHYSICS_VERSION, allocator, errors);
top.CreatePhysics(top.PHYSICS_VERSION, foundation, scale);
const cooking = new PX.PxCookingParams(scale);
cooking.planeTolerance = 0;
const vector = (v) => new PX.PxVec3(...v), list = ({ x, y, z }) => [x, y, z];
function hull(vertices) {
  const points = new PX.PxArray_PxVec3(vertices.length), desc = new PX.PxConvexMeshDesc();
  vertices.forEach((v, i) => points.set(i, vector(v)));
  desc.flags = new PX.PxConvexFlags(PX.PxConvexFlagEnum.eCOMPUTE_CONVEX);
  Object.assign(desc.points, { count: vertices.length, stride: 12, data: points.begin() });
  return new PX.PxConvexMeshGeometry(top.CreateConvexMesh(cooking, desc));
}
const pose = (p, q) => new PX.PxTransform(vector(p), new PX.PxQuat(...q));
`;

function geometry({ shape }) {
  if (shape.type === "sphere") return `new PX.PxSphereGeometry(${shape.radius})`;
  if (shape.type === "box") return `new PX.PxBoxGeometry(${shape.half_extents.join(", ")})`;
  return `hull(${JSON.stringify(shape.vertices)})`;
}

function pose({ X_WB: { p, q } }) {
  const { w, x, y, z } = unitQuaternion(q);
  return `pose(${JSON.stringify(p)}, ${JSON.stringify([x, y, z, w])})`;
}

const proximity = ({ bodies: [A, B] }) => `${head}const A = ${geometry(A)};
const B = ${geometry(B)};
const found = new PX.PxGjkQueryProximityInfoResult();
const near = PX.PxGjkQuery.prototype.proximityInfo(new PX.ConvexGeomSupport(A, 0), new PX.ConvexGeomSupport(B, 0),
  ${pose(A)}, ${pose(B)}, 1e18, 1, found);
console.log("near:", near, "distance:", found.separation); // below 0 if they overlap
console.log("on A:", list(found.pointA), "on B:", list(found.pointB), "axis:", list(found.separatingAxis));
`;

export const distance = proximity;
export const penetration = proximity;

// A sweep moves B.
export function time_of_impact(scene) {
  const { end, way } = straightCast(scene), [A, B] = scene.bodies, length = norm(way);
  const supports = "new PX.ConvexGeomSupport(A, 0), new PX.ConvexGeomSupport(B, 0)", poses = `${pose(A)}, ${pose(B)}`;
  const ask = length === 0 ? `console.log("overlap:", PX.PxGjkQuery.prototype.overlap(${supports},
  ${poses}));
` : `const found = new PX.PxGjkQuerySweepResult();
const hit = PX.PxGjkQuery.prototype.sweep(${supports}, ${poses},
  vector(${JSON.stringify(scaled(-1 / length, way))}), ${length}, found);
console.log("hit:", hit, "time:", ${end / length} * found.t);
`;
  return `${head}const A = ${geometry(A)};
const B = ${geometry(B)};
${ask}`;
}

export const bounds = (scene) => head + scene.bodies.map((body) => `{
  const box = new PX.PxBounds3();
  PX.PxGeometryQuery.prototype.computeGeomBounds(box, ${geometry(body)}, ${pose(body)}, 0);
  console.log("box from", list(box.minimum), "to", list(box.maximum));
}
`).join("");

const hasDensity = (body) => !body.mass || body.mass.type === "density";

export const mass = (scene) => head + scene.bodies.filter(hasDensity).map((body) => `{
  const unit = new PX.PxMassProperties(${geometry(body)}); // at 1 kg/m³; the body has ${body.mass?.density ?? 1}
  console.log("mass:", unit.mass, "centre:", list(unit.centerOfMass));
  console.log("inertia:", ["column0", "column1", "column2"].map((k) => list(unit.inertiaTensor[k])));
}
`).join("");
