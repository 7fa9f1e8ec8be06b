// Jolt's shapes for those of a scene. An object made with `new` is destroyed by hand, and a shape counts its references.
import { readFileSync } from "node:fs";
import { Abstain, Refused, unitQuaternion } from "../js/touchstone_adapter.mjs";

const { default: initJolt } = await import("jolt-physics");
export const JOLT = await initJolt();

/** An empty world; the caller destroys it. */
export function newWorld() {
  const settings = new JOLT.JoltSettings();
  const layers = new JOLT.ObjectLayerPairFilterTable(1), phases = new JOLT.BroadPhaseLayerInterfaceTable(1, 1);
  layers.EnableCollision(0, 0);
  phases.MapObjectToBroadPhaseLayer(0, new JOLT.BroadPhaseLayer(0));
  settings.mObjectLayerPairFilter = layers;
  settings.mBroadPhaseLayerInterface = phases;
  settings.mObjectVsBroadPhaseLayerFilter = new JOLT.ObjectVsBroadPhaseLayerFilterTable(phases, 1, layers, 1);
  const world = new JOLT.JoltInterface(settings);
  JOLT.destroy(settings);
  return world;
}

newWorld(); // registers the functions that collide shapes

const installed = new URL("node_modules/jolt-physics/package.json", import.meta.url);
export const version = JSON.parse(readFileSync(installed)).version;

// For the cards; the reasons: docs/how_to/add_a_subject.md.
export const homepage = "https://github.com/jrouwe/JoltPhysics";
export const domain = { lengths: [0.1, 10], fixed_lengths: [0.1, 2000], reach: 1000 };
export const distance_tolerance = { absolute: 1e-3 + 1e-4, relative: 1e-4 };

export const vector = (v) => new JOLT.Vec3(...v);
export const list = (v) => [v.GetX(), v.GetY(), v.GetZ()];

function settingsOf(shape) {
  if (shape.type === "compound") throw new Abstain("the queries are about one convex shape each");
  if (shape.type === "sphere") return new JOLT.SphereShapeSettings(shape.radius);
  if (shape.type === "box") {
    const half = vector(shape.half_extents), box = new JOLT.BoxShapeSettings(half, 0);
    JOLT.destroy(half);
    return box;
  }
  const hull = new JOLT.ConvexHullShapeSettings();
  hull.mMaxConvexRadius = 0;
  for (const v of shape.vertices) {
    const point = vector(v);
    hull.mPoints.push_back(point);
    JOLT.destroy(point);
  }
  return hull;
}

/** The caller releases it. */
export function shapeOf(shape, density) {
  const settings = settingsOf(shape);
  settings.mDensity = density;
  return made(settings);
}

/** The shape of settings, which are destroyed; the caller releases it. */
export function made(settings) {
  const created = settings.Create();
  const error = created.HasError() ? created.GetError().c_str() : "";
  const shape = error ? null : created.Get();
  shape?.AddRef();
  JOLT.destroy(settings);
  if (error) throw new Refused(error);
  return shape;
}

/** A body's shape at its pose; the caller releases it. */
export function placed(body, density) {
  const { w, x, y, z } = unitQuaternion(body.X_WB.q);
  const [p, q, one] = [vector(body.X_WB.p), new JOLT.Quat(x, y, z, w), vector([1, 1, 1])];
  const at = new JOLT.TransformedShape();
  at.mShape = shapeOf(body.shape, density);
  at.SetWorldTransform(p, q, one);
  [p, q, one].forEach(JOLT.destroy);
  return at;
}

export function release(...all) {
  for (const at of all) {
    at.mShape.Release();
    JOLT.destroy(at);
  }
}

/** The mass properties that Jolt computes for a body with a density. */
export function massOf(body) {
  const shape = shapeOf(body.shape, body.mass?.density ?? 1), found = shape.GetMassProperties();
  const columns = [0, 1, 2].map((i) => list(found.mInertia.GetColumn3(i)));
  const said = { mass: found.mMass, p_BBcm: list(shape.GetCenterOfMass()), I_BBcm_B: columns };
  shape.Release();
  return said;
}
