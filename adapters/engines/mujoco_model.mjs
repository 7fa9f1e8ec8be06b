// A scene as a MuJoCo model (MJCF), for the adapter and its snippets: each body has one geom.
import { Abstain, unitQuaternion } from "../js/touchstone_adapter.mjs";

const numbers = (list) => list.map(String).join(" ");

// Sizes are radii and half extents; quaternions are w x y z. Hulls are meshes.
function geom({ shape, mass }, i) {
  const density = `density="${mass?.density ?? 1}"`;
  if (shape.type === "sphere") return { geom: `<geom type="sphere" size="${shape.radius}" ${density}/>`, mesh: "" };
  if (shape.type === "box") return { geom: `<geom type="box" size="${numbers(shape.half_extents)}" ${density}/>`, mesh: "" };
  if (shape.type === "compound") throw new Abstain("the distance is one of two geoms");
  const mesh = `<mesh name="m${i}" vertex="${numbers(shape.vertices.flat())}" inertia="convex"/>`;
  return { geom: `<geom type="mesh" mesh="m${i}" ${density}/>`, mesh };
}

export function modelOf(scene) {
  const geoms = scene.bodies.map(geom);
  const bodies = scene.bodies.map(({ X_WB: { p, q } }, i) => {
    const { w, x, y, z } = unitQuaternion(q);
    return `<body pos="${numbers(p)}" quat="${numbers([w, x, y, z])}">${geoms[i].geom}</body>`;
  });
  return `<mujoco><compiler balanceinertia="false" boundmass="0" boundinertia="0"/>
<asset>${geoms.map((g) => g.mesh).join("\n")}</asset>
<worldbody>${bodies.join("\n")}</worldbody></mujoco>`;
}

/** The body alone, at the origin. */
export const alone = (body) => ({ bodies: [{ ...body, X_WB: { p: [0, 0, 0], q: { w: 1, x: 0, y: 0, z: 0 } } }] });
