// Programs in Jolt's own API for the adapter's queries: each asks what the adapter asks, and prints what Jolt says. They
// run where jolt-physics is installed: `node --input-type=module < snippet`.
import { unitQuaternion } from "../js/touchstone_adapter.mjs";
import { straightCast } from "./straight_cast.mjs";

const head = `import initJolt from "jolt-physics";
const Jolt = await initJolt();
const vector = (x, y, z) => new Jolt.Vec3(x, y, z), list = (v) => [v.GetX(), v.GetY(), v.GetZ()];
`;

// A world registers the functions that collide shapes.
const world = `const settings = new Jolt.JoltSettings();
const layers = new Jolt.ObjectLayerPairFilterTable(1), phases = new Jolt.BroadPhaseLayerInterfaceTable(1, 1);
phases.MapObjectToBroadPhaseLayer(0, new Jolt.BroadPhaseLayer(0));
settings.mObjectLayerPairFilter = layers;
settings.mBroadPhaseLayerInterface = phases;
settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(phases, 1, layers, 1);
new Jolt.JoltInterface(settings);
`;

function settingsOf({ shape }) {
  if (shape.type === "sphere") return `new Jolt.SphereShapeSettings(${shape.radius})`;
  if (shape.type === "box") return `new Jolt.BoxShapeSettings(vector(${shape.half_extents.join(", ")}), 0)`;
  return `new Jolt.ConvexHullShapeSettings()`;
}

const shape = (name, body) => `const of_${name} = ${settingsOf(body)};
of_${name}.mDensity = ${body.mass?.density ?? 1};
${body.shape.type === "polytope" ? `of_${name}.mMaxConvexRadius = 0;
${body.shape.vertices.map((v) => `of_${name}.mPoints.push_back(vector(${v.join(", ")}));\n`).join("")}` : ""}const ${
  name} = of_${name}.Create().Get();
`;

function placed(name, body) {
  const { w, x, y, z } = unitQuaternion(body.X_WB.q);
  return `${shape(name, body)}const at_${name} = new Jolt.TransformedShape();
at_${name}.mShape = ${name};
at_${name}.SetWorldTransform(vector(${body.X_WB.p.join(", ")}), new Jolt.Quat(${x}, ${y}, ${z}, ${w}), vector(1, 1, 1));
`;
}

const contact = ({ bodies: [A, B] }) => `${head}${world}${placed("A", A)}${placed("B", B)}
const [cA, cB] = [at_A, at_B].map((at) => list(at.mShapePositionCOM));
const how = new Jolt.CollideShapeSettings();
how.mMaxSeparationDistance = 1.01 * Math.hypot(...cA.map((c, i) => c - cB[i]));
const found = new Jolt.CollideShapeClosestHitCollisionCollector();
at_B.CollideShape(A, vector(1, 1, 1), at_A.GetCenterOfMassTransform(), how, vector(0, 0, 0), found,
  new Jolt.ShapeFilter());
console.log("hit:", found.HadHit(), "distance:", -found.mHit.mPenetrationDepth); // below 0 if they overlap
console.log("on A:", list(found.mHit.mContactPointOn1), "on B:", list(found.mHit.mContactPointOn2));
`;

export const distance = contact;
export const penetration = contact;

export function time_of_impact(scene) {
  const { end, way } = straightCast(scene), [A, B] = scene.bodies;
  return `${head}${world}${placed("A", A)}${placed("B", B)}
const how = new Jolt.ShapeCastSettings(), found = new Jolt.CastShapeClosestHitCollisionCollector();
how.mBackFaceModeConvex = Jolt.EBackFaceMode_CollideWithBackFaces;
const cast = new Jolt.RShapeCast(A, vector(1, 1, 1), at_A.GetCenterOfMassTransform(), vector(${way.join(", ")}));
at_B.CastShape(cast, how, vector(0, 0, 0), found, new Jolt.ShapeFilter());
console.log("hit:", found.HadHit(), "time:", ${end} * found.mHit.mFraction);
`;
}

export const bounds = (scene) => head + scene.bodies.map((body) => `{
${placed("A", body)}const box = at_A.GetWorldSpaceBounds();
console.log("box from", list(box.mMin), "to", list(box.mMax));
}
`).join("");

const hasDensity = (body) => !body.mass || body.mass.type === "density";

export const mass = (scene) => head + scene.bodies.filter(hasDensity).map((body) => `{
${shape("A", body)}const found = A.GetMassProperties();
console.log("mass:", found.mMass, "centre:", list(A.GetCenterOfMass()));
console.log("inertia:", [0, 1, 2].map((i) => list(found.mInertia.GetColumn3(i))));
}
`).join("");
