// Programs in Rapier's own API for the adapter's queries: each asks what the adapter asks, and prints what Rapier says.
// They run where @dimforge/rapier3d-compat is installed: `node --input-type=module < snippet`.
import { unitQuaternion } from "../js/touchstone_adapter.mjs";
import { forceAt, sampled, step } from "./sampled_motion.mjs";
import { straightCast } from "./straight_cast.mjs";

const head = `import RAPIER from "@dimforge/rapier3d-compat";
await RAPIER.init();
`;

const vector = ([x, y, z]) => JSON.stringify({ x, y, z });

function colliderOf({ shape }) {
  if (shape.type === "sphere") return `RAPIER.ColliderDesc.ball(${shape.radius})`;
  if (shape.type === "box") return `RAPIER.ColliderDesc.cuboid(${shape.half_extents.join(", ")})`;
  return `RAPIER.ColliderDesc.convexHull(new Float32Array([\n${shape.vertices.map((v) => `  ${v.join(", ")},\n`).join("")}]))`;
}

const body = (name, b) => `const ${name} = ${colliderOf(b)}.shape;
const p_${name} = ${vector(b.X_WB.p)}, q_${name} = ${JSON.stringify(unitQuaternion(b.X_WB.q))};
`;

const contact = (scene) => {
  const [A, B] = scene.bodies;
  return `${head}${body("A", A)}${body("B", B)}const found = A.contactShape(p_A, q_A, B, p_B, q_B, 3.4e38);
console.log("distance:", found?.distance); // below 0 if they overlap
`;
};

export const distance = contact;
export const penetration = contact;

export function time_of_impact(scene) {
  const { end, v_A, v_B } = straightCast(scene), [A, B] = scene.bodies;
  return `${head}${body("A", A)}${body("B", B)}const hit = A.castShape(p_A, q_A, ${vector(v_A)}, B, p_B, q_B,
  ${vector(v_B)}, 0, ${end}, false);
console.log("time:", hit?.time_of_impact);
`;
}

const hasDensity = (body) => !body.mass || body.mass.type === "density";

/** A moment is also seen in a motion: an angular impulse of 1 about a principal axis gives the angular velocity 1/I. */
export const mass = (scene) => head + scene.bodies.filter(hasDensity).map((body) => `{
  const world = new RAPIER.World({ x: 0, y: 0, z: 0 });
  const body = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic());
  world.createCollider(${colliderOf(body)}.setDensity(${body.mass?.density ?? 1}), body);
  body.recomputeMassPropertiesFromColliders();
  console.log("mass:", body.mass(), "centre:", body.localCom());
  console.log("principal moments:", body.principalInertia(), "axes:", body.principalInertiaLocalFrame());
  world.step();
  for (const axis of ["x", "y", "z"]) {
    body.setAngvel({ x: 0, y: 0, z: 0 }, true);
    body.applyTorqueImpulse({ x: 0, y: 0, z: 0, [axis]: 1 }, true);
    console.log("an angular impulse of 1 about", axis, "gives", body.angvel());
  }
}
`).join("");

function moving(body) {
  const { v_WBcm = [0, 0, 0], w_WB = [0, 0, 0] } = body.velocity ?? {}, { mass, material, shape } = body;
  const kind = mass?.type === "fixed" ? "kinematicVelocityBased" : "dynamic", given = mass?.type === "given";
  const moments = given ? mass.I_BBcm_B.map((row, i) => row[i]) : [];
  const collider = ({ shape: part, X_BP }) => `world.createCollider(${colliderOf({ shape: part })}
  .setDensity(${given ? 0 : mass?.density ?? 1}).setRestitution(${material?.restitution ?? 0})
  .setFriction(${material?.friction ?? 0}).setRestitutionCombineRule(Min).setFrictionCombineRule(Min)${X_BP ? `
  .setTranslation(${X_BP.p.join(", ")}).setRotation(${JSON.stringify(unitQuaternion(X_BP.q))})` : ""}, bodies.at(-1));
`;
  return `bodies.push(world.createRigidBody(RAPIER.RigidBodyDesc.${kind}().setCanSleep(false)
  .setTranslation(${body.X_WB.p.join(", ")}).setRotation(${JSON.stringify(unitQuaternion(body.X_WB.q))})
  .setLinvel(${v_WBcm.join(", ")}).setAngvel(${vector(w_WB)})${given ? `
  .setAdditionalMassProperties(${mass.mass}, ${vector(mass.p_BBcm)}, ${vector(moments)},
    { w: 1, x: 0, y: 0, z: 0 })` : ""}));
${(shape.type === "compound" ? shape.parts : [{ shape }]).map(collider).join("")}`;
}

/** The steps that the adapter takes, and the states that it samples. */
export function simulation({ bodies, gravity = [0, 0, 0], motion }) {
  const forces = motion.forces ?? [], lines = [];
  const go = (from, to) => {
    const steps = Math.ceil((to - from) / step);
    lines.push(`world.timestep = ${(to - from) / steps};`);
    if (forces.length > 0) {
      bodies.forEach((_, i) => lines.push(`bodies[${i}].resetForces(true);`,
        `bodies[${i}].addForce(${vector(forceAt(forces, i, from))}, true);`));
    }
    lines.push(`for (let k = 0; k < ${steps}; ++k) world.step();`);
  };
  sampled(motion, go, () => lines.push("sample();"));
  return `${head}const { Min } = RAPIER.CoefficientCombineRule;
const world = new RAPIER.World(${vector(gravity)}), bodies = [];
const sample = () => bodies.forEach((body, i) => console.log("body", i, "at:", body.translation(), body.rotation(),
  "velocity:", body.linvel(), body.angvel()));
${bodies.map(moving).join("")}${lines.join("\n")}
`;
}
