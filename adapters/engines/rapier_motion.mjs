// Rapier's simulation: a world with the bodies of a scene, in equal steps of at most `step` between sample times.
import { Abstain, unitQuaternion } from "../js/touchstone_adapter.mjs";
import { RAPIER, colliderOf, list, vector } from "./rapier_bodies.mjs";
import { forceAt, requireOffered, sampled, step } from "./sampled_motion.mjs";

const { Min } = RAPIER.CoefficientCombineRule;

function addTo(world, body) {
  const { v_WBcm = [0, 0, 0], w_WB = [0, 0, 0] } = body.velocity ?? {};
  const kind = body.mass?.type === "fixed" ? RAPIER.RigidBodyDesc.kinematicVelocityBased() : RAPIER.RigidBodyDesc.dynamic();
  const desc = kind.setTranslation(...body.X_WB.p).setRotation(unitQuaternion(body.X_WB.q)).setCanSleep(false)
    .setLinvel(...v_WBcm).setAngvel(vector(w_WB));
  if (body.mass?.type === "given") {
    const { mass, p_BBcm, I_BBcm_B: I } = body.mass;
    if (I.some((row, i) => row.some((x, j) => i !== j && x !== 0))) throw new Abstain("an inertia that is not diagonal");
    desc.setAdditionalMassProperties(mass, vector(p_BBcm), vector([I[0][0], I[1][1], I[2][2]]), { w: 1, x: 0, y: 0, z: 0 });
  }
  const rigid = world.createRigidBody(desc);
  const { restitution = 0, friction = 0 } = body.material ?? {};
  const parts = body.shape.type === "compound" ? body.shape.parts : [{ shape: body.shape }];
  for (const { shape, X_BP } of parts) {
    const collider = colliderOf(shape).setDensity(body.mass?.type === "given" ? 0 : body.mass?.density ?? 1)
      .setRestitution(restitution).setFriction(friction)
      .setRestitutionCombineRule(Min).setFrictionCombineRule(Min);
    if (X_BP) collider.setTranslation(...X_BP.p).setRotation(unitQuaternion(X_BP.q));
    world.createCollider(collider, rigid);
  }
  return rigid;
}

const state = (rigid) => ({
  X_WB: { p: list(rigid.translation()), q: rigid.rotation() },
  velocity: { v_WBcm: list(rigid.linvel()), w_WB: list(rigid.angvel()) },
});

export function simulation(scene) {
  requireOffered(scene);
  const { forces = [] } = scene.motion;
  const world = new RAPIER.World(vector(scene.gravity ?? [0, 0, 0]));
  try {
    const bodies = scene.bodies.map((body) => addTo(world, body));
    const go = (from, to) => {
      bodies.forEach((rigid, i) => { rigid.resetForces(true); rigid.addForce(vector(forceAt(forces, i, from)), true); });
      const steps = Math.ceil((to - from) / step);
      world.timestep = (to - from) / steps;
      for (let k = 0; k < steps; ++k) world.step();
    };
    return { states: sampled(scene.motion, go, () => bodies.map(state)) };
  } finally {
    world.free();
  }
}
