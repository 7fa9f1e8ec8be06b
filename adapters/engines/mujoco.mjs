// An adapter of MuJoCo for Touchstone: `npm ci` in this folder, then
//     touchstone adapter check "exec:node adapters/engines/mujoco.mjs"
import { Abstain, norm, rotated, scaled, serve, sub, unitQuaternion } from "../js/touchstone_adapter.mjs";

const mujoco = await (await import("mujoco-js")).default();

const card = {
  name: "mujoco", version: mujoco.mj_versionString(), precision: "binary64",
  about: "mj_geomDistance, margin 0; body_mass, body_ipos, body_inertia, body_iquat; hulls are meshes, which are floats",
  homepage: "https://mujoco.org",
};

const numbers = (list) => list.map(String).join(" ");
// Sizes are radii and half extents; quaternions are w x y z.
function geom({ shape, mass }, i) {
  const density = `density="${mass?.density ?? 1}"`;
  if (shape.type === "sphere") return { geom: `<geom type="sphere" size="${shape.radius}" ${density}/>`, mesh: "" };
  if (shape.type === "box") return { geom: `<geom type="box" size="${numbers(shape.half_extents)}" ${density}/>`, mesh: "" };
  if (shape.type === "compound") throw new Abstain("the distance is one of two geoms");
  const mesh = `<mesh name="m${i}" vertex="${numbers(shape.vertices.flat())}" inertia="convex"/>`;
  return { geom: `<geom type="mesh" mesh="m${i}" ${density}/>`, mesh };
}

// Calls `ask` with a model of the scene's bodies, each with one geom, and its data after mj_forward.
function withModel(scene, ask) {
  const geoms = scene.bodies.map(geom);
  const bodies = scene.bodies.map(({ X_WB: { p, q } }, i) => {
    const { w, x, y, z } = unitQuaternion(q);
    return `<body pos="${numbers(p)}" quat="${numbers([w, x, y, z])}"><freejoint/>${geoms[i].geom}</body>`;
  });
  const xml = `<mujoco><compiler balanceinertia="false" boundmass="0" boundinertia="0"/><asset>
    ${geoms.map((g) => g.mesh).join("")}</asset><worldbody>${bodies.join("")}</worldbody></mujoco>`;
  mujoco.FS.writeFile("/scene.xml", xml);
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
  const { d, a, b } = closest(scene);
  return d >= 0 ? { verdict: "separated", depth: 0 }
    : { verdict: "overlapping", depth: -d, nhat_BA_W: scaled(1 / norm(sub(b, a)), sub(b, a)) };
}

const mass = (scene) => scene.bodies.map((body) => {
  if (body.mass?.type === "fixed") return null;
  if (body.mass?.type === "given") return { ...body.mass, type: undefined };
  return withModel({ bodies: [{ ...body, X_WB: { p: [0, 0, 0], q: { w: 1, x: 0, y: 0, z: 0 } } }] }, (model) => {
    const [w, x, y, z] = model.body_iquat.slice(4, 8);
    const F = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((axis) => rotated({ w, x, y, z }, axis)); // principal axes, in the body
    const entry = (i, j) => F.reduce((sum, f, k) => sum + model.body_inertia[3 + k] * f[i] * f[j], 0);
    const I_BBcm_B = [0, 1, 2].map((i) => [0, 1, 2].map((j) => entry(i, j)));
    return { mass: model.body_mass[1], p_BBcm: model.body_ipos.slice(3, 6), I_BBcm_B };
  });
});

serve(card, { mass, distance, penetration });
