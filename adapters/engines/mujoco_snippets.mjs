// Programs in MuJoCo's own API for the adapter's queries: each asks what the adapter asks, and prints what MuJoCo says.
// They run where mujoco-js is installed: `node --input-type=module < snippet`.
import { alone, modelOf } from "./mujoco_model.mjs";

const head = `import load from "mujoco-js";
const mujoco = await load();
`;

const model = (scene) => `mujoco.FS.writeFile("/scene.xml", \`${modelOf(scene)}\`);
const model = mujoco.MjModel.loadFromXML("/scene.xml");
`;

const closest = (scene) => `${head}${model(scene)}const data = new mujoco.MjData(model);
mujoco.mj_forward(model, data);
const ends = new mujoco.DoubleBuffer(6);
console.log("distance:", mujoco.mj_geomDistance(model, data, 0, 1, 1e300, ends)); // below 0 if they overlap
console.log("closest or deepest points:", [...ends.GetView()]);
`;

export const distance = closest;
export const penetration = closest;

const hasDensity = (body) => !body.mass || body.mass.type === "density";

export const mass = (scene) => head + scene.bodies.filter(hasDensity).map((body) => `{
${model(alone(body))}console.log("mass:", model.body_mass[1], "centre:", [...model.body_ipos.slice(3, 6)]);
console.log("principal moments:", [...model.body_inertia.slice(3, 6)], "axes:", [...model.body_iquat.slice(4, 8)]);
}
`).join("");
