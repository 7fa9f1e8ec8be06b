// An adapter of PhysX for Touchstone: `./touchstone engines`, or `npm ci` in this folder, then
//     touchstone adapter check "exec:node adapters/engines/physx.mjs"
import { norm, scaled, serve } from "../js/touchstone_adapter.mjs";
import {
  PX, domain, homepage, list, massOf, using, vector, version, withGeometry, withPose,
} from "./physx_bodies.mjs";
import * as snippets from "./physx_snippets.mjs";
import { met, straightCast } from "./straight_cast.mjs";

const card = {
  name: "physx", version, precision: "binary32",
  about: "PxGjkQuery.proximityInfo, sweep and overlap of ConvexGeomSupport without margin; PxMassProperties of a "
    + "geometry; PxGeometryQuery.computeGeomBounds; hulls cooked with planeTolerance 0",
  homepage, domain,
  contact_tolerance: { size: 0.0025 }, // a tenth of the sweep margin, which is 0.05 of the least half extent at most
  deviations: [{
    clause: "TS-TIME-OF-IMPACT-5",
    what: "a sweep counts shapes that touch or overlap at its start as hit at 0, whether they approach or part",
    link: "https://nvidia-omniverse.github.io/PhysX/physx/5.6.0/_api_build/structPxSweepHit.html",
  }],
};

const withSupport = (body, use) => withGeometry(body.shape, (geometry) =>
  using(new PX.ConvexGeomSupport(geometry, 0), (support) => withPose(body.X_WB, (pose) => use(support, pose))));

// The closest or deepest points of A and B; the separation is negative if they overlap. Nothing, if PhysX says that they
// are farther apart than any distance: so it ends where its iterations fail.
const proximity = ({ bodies: [A, B] }) => withSupport(A, (a, pose_A) => withSupport(B, (b, pose_B) =>
  using(new PX.PxGjkQueryProximityInfoResult(), (found) => {
    if (!PX.PxGjkQuery.prototype.proximityInfo(a, b, pose_A, pose_B, 1e18, 1, found)) return null;
    return { separation: found.separation, p_WCa: list(found.pointA), p_WCb: list(found.pointB),
      axis: list(found.separatingAxis) };
  })));

function distance(scene) {
  const near = proximity(scene);
  if (!near) return { verdict: "separated" };
  const { separation, p_WCa, p_WCb } = near;
  if (separation < 0) return { verdict: "overlapping", distance: 0 };
  return { verdict: "separated", distance: separation, p_WCa, p_WCb };
}

function penetration(scene) {
  const { separation, axis } = proximity(scene) ?? { separation: Infinity };
  if (separation >= 0) return { verdict: "separated", depth: 0 };
  return { verdict: "overlapping", depth: -separation, nhat_BA_W: scaled(1 / norm(axis), axis) };
}

const bounds = (scene) => scene.bodies.map((body) => withGeometry(body.shape, (geometry) =>
  withPose(body.X_WB, (pose) => using(new PX.PxBounds3(), (box) => {
    PX.PxGeometryQuery.prototype.computeGeomBounds(box, geometry, pose, 0);
    return { lo: list(box.minimum), hi: list(box.maximum) };
  }))));

const mass = (scene) => scene.bodies.map((body) => {
  if (body.mass?.type === "fixed") return null;
  return body.mass?.type === "given" ? { ...body.mass, type: undefined } : massOf(body);
});

// A sweep moves B.
function time_of_impact(scene) {
  const { end, way } = straightCast(scene), length = norm(way), query = PX.PxGjkQuery.prototype;
  return withSupport(scene.bodies[0], (a, pose_A) => withSupport(scene.bodies[1], (b, pose_B) => {
    if (length === 0) return met(query.overlap(a, b, pose_A, pose_B) ? 0 : null); // a sweep needs a direction
    return using(vector(scaled(-1 / length, way)), (along) => using(new PX.PxGjkQuerySweepResult(), (hit) => met(
      query.sweep(a, b, pose_A, pose_B, along, length, hit) ? end * hit.t / length : null)));
  }));
}

serve(card, { mass, bounds, distance, penetration, time_of_impact }, snippets);
