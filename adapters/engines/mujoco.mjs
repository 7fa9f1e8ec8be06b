// An adapter of MuJoCo for Touchstone: `npm ci` in this folder, then
//     touchstone adapter check "exec:node adapters/engines/mujoco.mjs"
import { norm, rotated, scaled, serve, sub } from "../js/touchstone_adapter.mjs";
import { alone, modelOf } from "./mujoco_model.mjs";
import * as snippets from "./mujoco_snippets.mjs";

const mujoco = await (await import("mujoco-js")).default();

const card = {
  name: "mujoco", version: mujoco.mj_versionString(), precision: "binary64",
  about: "mj_geomDistance, margin 0; body_mass, body_ipos, body_inertia, body_iquat; hulls are meshes, which are floats",
  homepage: "https://mujoco.org",
  domain: { lengths: [0.01, 1e10], reach: 1e10 }, // the reasons: docs/how_to/add_a_subject.md
  precision_of: { polytope: "binary32" }, // the vertices of meshes are floats
  distance_tolerance: { absolute: 1e-6 }, // opt.ccd_tolerance as shipped
};

// Calls `ask` with a model of the scene's bodies, each with one geom, and its data after mj_forward.
function withModel(scene, ask) {
  mujoco.FS.writeFile("/scene.xml", modelOf(scene));
  const model = mujoco.MjModel.loadFromXML("/scene.xml");
  const data = new mujoco.MjData(model);
  try {
    mujoco.mj_forward(model, data);
    return ask(model, data);
  } finally {
    data.delete();
    model.delete();
  }
}

// The signed distance, and the closest points of A and B, or the deepest.
function closest(scene) {
  return withModel(scene, (model, data) => {
    const ends = new mujoco.DoubleBuffer(6);
    const d = mujoco.mj_geomDistance(model, data, 0, 1, 1e300, ends);
    const [...p] = ends.GetView();
    ends.delete();
    return { d, a: p.slice(0, 3), b: p.slice(3) };
  });
}

function distance(scene) {
  const { d, a, b } = closest(scene);
  return d < 0 ? { verdict: "overlapping", distance: 0 } : { verdict: "separated", distance: d, p_WCa: a, p_WCb: b };
}

function penetration(scene) {
  const { d, a, b } = closest(scene), out = sub(b, a), size = norm(out);
  if (d >= 0) return { verdict: "separated", depth: 0 };
  // Where the two points are one the engine says no direction.
  return { verdict: "overlapping", depth: -d, ...(size > 0 && { nhat_BA_W: scaled(1 / size, out) }) };
}

const mass = (scene) => scene.bodies.map((body) => {
  if (body.mass?.type === "fixed") return null;
  if (body.mass?.type === "given") return { ...body.mass, type: undefined };
  return withModel(alone(body), (model) => {
    const [w, x, y, z] = model.body_iquat.slice(4, 8);
    const F = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((axis) => rotated({ w, x, y, z }, axis)); // principal axes, in the body
    const entry = (i, j) => F.reduce((sum, f, k) => sum + model.body_inertia[3 + k] * f[i] * f[j], 0);
    const I_BBcm_B = [0, 1, 2].map((i) => [0, 1, 2].map((j) => entry(i, j)));
    return { mass: model.body_mass[1], p_BBcm: model.body_ipos.slice(3, 6), I_BBcm_B };
  });
});

serve(card, { mass, distance, penetration }, snippets);
