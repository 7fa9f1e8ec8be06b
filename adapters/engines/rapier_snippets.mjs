// Programs in Rapier's own API for the adapter's queries: each asks what the adapter asks, and prints what Rapier says.
// They run where @dimforge/rapier3d-compat is installed: `node --input-type=module < snippet`.
import { unitQuaternion } from "../js/touchstone_adapter.mjs";

const head = `import RAPIER from "@dimforge/rapier3d-compat";
await RAPIER.init();
`;

const vector = ([x, y, z]) => JSON.stringify({ x, y, z });

function colliderOf({ shape }) {
  if (shape.type === "sphere") return `RAPIER.ColliderDesc.ball(${shape.radius})`;
  if (shape.type === "box") return `RAPIER.ColliderDesc.cuboid(${shape.half_extents.join(", ")})`;
  return `RAPIER.ColliderDesc.convexHull(new Float32Array([\n${shape.vertices.map((v) => `  ${v.join(", ")},\n`).join("")}]))`;
}

const contact = (scene) => {
  const body = (name, b) => `const ${name} = ${colliderOf(b)}.shape;
const p_${name} = ${vector(b.X_WB.p)}, q_${name} = ${JSON.stringify(unitQuaternion(b.X_WB.q))};
`;
  const [A, B] = scene.bodies;
  return `${head}${body("A", A)}${body("B", B)}const found = A.contactShape(p_A, q_A, B, p_B, q_B, 3.4e38);
console.log("distance:", found?.distance); // below 0 if they overlap
`;
};

export const distance = contact;
export const penetration = contact;

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
