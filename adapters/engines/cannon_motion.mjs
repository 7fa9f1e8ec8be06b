// The simulation of cannon-es: a world with the bodies of a scene, in equal steps of at most `step` between samples.
import { CANNON, bodyOf, list, poseOf, vector } from "./cannon_bodies.mjs";
import { forceAt, requireOffered, sampled, step } from "./sampled_motion.mjs";

/** The engine multiplies the coefficients of two materials; a contact material of each pair has the lesser ones. */
function addPairs(world, scene, bodies, relaxation) {
  bodies.forEach(({ rigid: a }, i) => bodies.slice(0, i).forEach(({ rigid: b }, j) => {
    const [A, B] = [i, j].map((k) => ({ restitution: 0, friction: 0, ...scene.bodies[k].material }));
    world.addContactMaterial(new CANNON.ContactMaterial(a.material, b.material, {
      restitution: Math.min(A.restitution, B.restitution), friction: Math.min(A.friction, B.friction),
      contactEquationRelaxation: relaxation,
    }));
  }));
}

const state = (body) => ({
  X_WB: poseOf(body), velocity: { v_WBcm: list(body.rigid.velocity), w_WB: list(body.rigid.angularVelocity) },
});

/** `relaxation`: after how many steps a contact that is too deep is pushed apart. */
export const simulationWith = (relaxation) => (scene) => {
  requireOffered(scene);
  const { forces = [] } = scene.motion;
  const world = new CANNON.World({ gravity: vector(scene.gravity ?? [0, 0, 0]) });
  const bodies = scene.bodies.map(bodyOf);
  bodies.forEach(({ rigid }) => world.addBody(rigid));
  addPairs(world, scene, bodies, relaxation);
  const go = (from, to) => {
    const steps = Math.ceil((to - from) / step);
    for (let k = 0; k < steps; ++k) {
      bodies.forEach(({ rigid }, i) => rigid.applyForce(vector(forceAt(forces, i, from)))); // a step ends with no force
      world.step((to - from) / steps);
    }
  };
  return { states: sampled(scene.motion, go, () => bodies.map(state)) };
};
