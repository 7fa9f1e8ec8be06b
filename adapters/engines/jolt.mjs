// An adapter of Jolt for Touchstone: `./touchstone engines`, or `npm ci` in this folder, then
//     touchstone adapter check "exec:node adapters/engines/jolt.mjs"
import { norm, scaled, serve, sub } from "../js/touchstone_adapter.mjs";
import { JOLT, list, placed, release, shapeOf, vector, version } from "./jolt_bodies.mjs";
import * as snippets from "./jolt_snippets.mjs";

const card = {
  name: "jolt", version, precision: "binary32",
  about: "TransformedShape.CollideShape up to the distance of the centres of mass; Shape.GetMassProperties and "
    + "GetCenterOfMass; TransformedShape.GetWorldSpaceBounds; convex radius 0",
  homepage: "https://github.com/jrouwe/JoltPhysics",
  // The reasons: docs/how_to/add_a_subject.md.
  domain: { lengths: [0.1, 10], reach: 1000 },
  distance_tolerance: { absolute: 1e-3 + 1e-4, relative: 1e-4 },
  boxes: "of_turned_box",
};

const settings = new JOLT.CollideShapeSettings();

// The closest or deepest points of A (1) and B (2) in the world; the distance is negative if they overlap.
function contact(scene) {
  const [A, B] = scene.bodies.map((body) => placed(body, 1));
  // Jolt enlarges the shapes by this distance, so it is as small as it may be: the centres of mass are farther apart.
  settings.mMaxSeparationDistance = 1.01 * norm(sub(list(A.mShapePositionCOM), list(B.mShapePositionCOM)));
  const collector = new JOLT.CollideShapeClosestHitCollisionCollector();
  const [one, origin, filter] = [vector([1, 1, 1]), vector([0, 0, 0]), new JOLT.ShapeFilter()];
  try {
    B.CollideShape(A.mShape, one, A.GetCenterOfMassTransform(), settings, origin, collector, filter);
    if (!collector.HadHit()) throw new Error("CollideShape finds nothing up to the distance of the centres of mass");
    const hit = collector.mHit;
    return { distance: -hit.mPenetrationDepth, p_WCa: list(hit.mContactPointOn1), p_WCb: list(hit.mContactPointOn2),
      to_B: list(hit.mPenetrationAxis) };
  } finally {
    release(A, B);
    [collector, one, origin, filter].forEach(JOLT.destroy);
  }
}

function distance(scene) {
  const { distance: d, p_WCa, p_WCb } = contact(scene);
  return d < 0 ? { verdict: "overlapping", distance: 0 } : { verdict: "separated", distance: d, p_WCa, p_WCb };
}

function penetration(scene) {
  const { distance: d, to_B } = contact(scene);
  if (d >= 0) return { verdict: "separated", depth: 0 };
  return { verdict: "overlapping", depth: -d, nhat_BA_W: scaled(-1 / norm(to_B), to_B) };
}

const bounds = (scene) => scene.bodies.map((body) => {
  const at = placed(body, 1), box = at.GetWorldSpaceBounds();
  const found = { lo: list(box.mMin), hi: list(box.mMax) };
  release(at);
  return found;
});

const mass = (scene) => scene.bodies.map((body) => {
  if (body.mass?.type === "fixed") return null;
  if (body.mass?.type === "given") return { ...body.mass, type: undefined };
  const shape = shapeOf(body.shape, body.mass?.density ?? 1), found = shape.GetMassProperties();
  const columns = [0, 1, 2].map((i) => list(found.mInertia.GetColumn3(i)));
  const said = { mass: found.mMass, p_BBcm: list(shape.GetCenterOfMass()), I_BBcm_B: columns };
  shape.Release();
  return said;
});

serve(card, { mass, bounds, distance, penetration }, snippets);
