// An adapter of Jolt for Touchstone: `./touchstone engines`, or `npm ci` in this folder, then
//     touchstone adapter check "exec:node adapters/engines/jolt.mjs"
import { norm, scaled, serve, sub } from "../js/touchstone_adapter.mjs";
import {
  JOLT, distance_tolerance, domain, homepage, list, massOf, placed, release, vector, version,
} from "./jolt_bodies.mjs";
import * as snippets from "./jolt_snippets.mjs";
import { met, straightCast } from "./straight_cast.mjs";

const card = {
  name: "jolt", version, precision: "binary32",
  about: "TransformedShape.CollideShape up to the distance of the centres of mass; Shape.GetMassProperties and "
    + "GetCenterOfMass; TransformedShape.GetWorldSpaceBounds; TransformedShape.CastShape of bodies that do not turn; "
    + "convex radius 0",
  homepage, domain, distance_tolerance, boxes: "of_turned_box",
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

const casting = new JOLT.ShapeCastSettings();
casting.mBackFaceModeConvex = JOLT.EBackFaceMode_CollideWithBackFaces; // bodies that overlap at the start have met

function time_of_impact(scene) {
  const { end, way } = straightCast(scene), [A, B] = scene.bodies.map((body) => placed(body, 1));
  const [one, along, origin] = [vector([1, 1, 1]), vector(way), vector([0, 0, 0])];
  const cast = new JOLT.RShapeCast(A.mShape, one, A.GetCenterOfMassTransform(), along);
  const collector = new JOLT.CastShapeClosestHitCollisionCollector(), filter = new JOLT.ShapeFilter();
  B.CastShape(cast, casting, origin, collector, filter);
  const time = collector.HadHit() ? end * collector.mHit.mFraction : null;
  release(A, B);
  [one, along, origin, cast, collector, filter].forEach(JOLT.destroy);
  return met(time);
}

const bounds = (scene) => scene.bodies.map((body) => {
  const at = placed(body, 1), box = at.GetWorldSpaceBounds();
  const found = { lo: list(box.mMin), hi: list(box.mMax) };
  release(at);
  return found;
});

const mass = (scene) => scene.bodies.map((body) => {
  if (body.mass?.type === "fixed") return null;
  return body.mass?.type === "given" ? { ...body.mass, type: undefined } : massOf(body);
});

serve(card, { mass, bounds, distance, penetration, time_of_impact }, snippets);
