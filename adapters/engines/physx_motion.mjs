// PhysX's simulation: a scene with the bodies of a scene, in equal steps of at most `step` between sample times.
import { add, norm, scaled, serve, unitQuaternion } from "../js/touchstone_adapter.mjs";
import { after, impactScene } from "./impact_scene.mjs";
import {
  PX, domain, homepage, list, massOf, physics, scale, top, using, vector, version, withGeometry, withPose,
} from "./physx_bodies.mjs";
import { forceAt, requireOffered, sampled, step } from "./sampled_motion.mjs";

const gyroscopic = 1 << 10; // PxRigidBodyFlag::eENABLE_GYROSCOPIC_FORCES, which the binding does not name
const shapeFlags = new PX.PxShapeFlags(PX.PxShapeFlagEnum.eSIMULATION_SHAPE);
const everything = new PX.PxFilterData(1, 1, 0, 0); // the binding's filter lets groups collide: here, all with all
const origin = { p: [0, 0, 0], q: { w: 1, x: 0, y: 0, z: 0 } };

function materialOf({ material: { restitution = 0, friction = 0 } = {} }) {
  const made = physics.createMaterial(friction, friction, restitution);
  made.setFrictionCombineMode(PX.PxCombineModeEnum.eMIN);
  made.setRestitutionCombineMode(PX.PxCombineModeEnum.eMIN);
  return made;
}

function addShapes(rigid, body) {
  const material = materialOf(body);
  const { shape: whole } = body, parts = whole.type === "compound" ? whole.parts : [{ shape: whole, X_BP: origin }];
  for (const { shape, X_BP } of parts) {
    withGeometry(shape, (geometry) => {
      const made = physics.createShape(geometry, material, true, shapeFlags);
      withPose(X_BP, (pose) => made.setLocalPose(pose));
      made.setSimulationFilterData(everything);
      rigid.attachShape(made);
      made.release(); // the body holds it
    });
  }
  material.release();
}

/** PhysX has an inertia in its principal axes, which it computes. */
function setMass(rigid, { mass, p_BBcm, I_BBcm_B }) {
  const columns = I_BBcm_B.map(vector), tensor = new PX.PxMat33(...columns), axes = new PX.PxQuat();
  const moments = PX.PxMassProperties.prototype.getMassSpaceInertia(tensor, axes);
  rigid.setMass(mass);
  rigid.setMassSpaceInertiaTensor(moments);
  using(vector(p_BBcm), (p) => using(new PX.PxTransform(p, axes), (pose) => rigid.setCMassLocalPose(pose)));
  [...columns, tensor, axes].forEach(PX.destroy);
}

function addTo(world, body) {
  const { v_WBcm = [0, 0, 0], w_WB = [0, 0, 0] } = body.velocity ?? {};
  const fixed = body.mass?.type === "fixed", rigid = withPose(body.X_WB, (pose) => physics.createRigidDynamic(pose));
  addShapes(rigid, body);
  rigid.setRigidBodyFlag(PX.PxRigidBodyFlagEnum.eKINEMATIC, fixed);
  rigid.setRigidBodyFlag(gyroscopic, true);
  if (body.mass?.type === "given") setMass(rigid, body.mass);
  else if (!fixed) PX.PxRigidBodyExt.prototype.updateMassAndInertia(rigid, body.mass?.density ?? 1);
  rigid.setLinearDamping(0);
  rigid.setAngularDamping(0);
  rigid.setSleepThreshold(0);
  if (!fixed) {
    using(vector(v_WBcm), (v) => rigid.setLinearVelocity(v));
    using(vector(w_WB), (w) => rigid.setAngularVelocity(w));
  }
  world.addActor(rigid);
  return rigid;
}

const product = (a, b) => ({
  w: a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, x: a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
  y: a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, z: a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w,
});

/** A kinematic body is moved to where its velocity leads it from its start. */
function drive(rigid, { X_WB, velocity: { v_WBcm = [0, 0, 0], w_WB = [0, 0, 0] } = {} }, time) {
  const angle = norm(w_WB) * time, axis = scaled(angle === 0 ? 0 : Math.sin(angle / 2) / norm(w_WB), w_WB);
  const q = product({ w: Math.cos(angle / 2), x: axis[0], y: axis[1], z: axis[2] }, unitQuaternion(X_WB.q));
  withPose({ p: add(X_WB.p, scaled(time, v_WBcm)), q }, (pose) => rigid.setKinematicTarget(pose));
}

const state = (rigid) => {
  const { p, q } = rigid.getGlobalPose();
  return { X_WB: { p: list(p), q: { w: q.w, x: q.x, y: q.y, z: q.z } },
    velocity: { v_WBcm: list(rigid.getLinearVelocity()), w_WB: list(rigid.getAngularVelocity()) } };
};

const dispatcher = top.DefaultCpuDispatcherCreate(0);

function newWorld({ gravity = [0, 0, 0] }, threshold) {
  const desc = new PX.PxSceneDesc(scale);
  using(vector(gravity), (g) => { desc.gravity = g; });
  Object.assign(desc, { cpuDispatcher: dispatcher, filterShader: top.DefaultFilterShader(),
    bounceThresholdVelocity: threshold });
  const world = physics.createScene(desc);
  PX.destroy(desc);
  return world;
}

const about = "PxScene.simulate, equal steps of at most 1/256 s between sample times, without damping and sleep, with "
  + "the gyroscopic term, e and mu of a pair the lesser, hulls cooked with planeTolerance 0; impulse is asked of two "
  + "balls of radius 1, in one step without the gyroscopic term and without pushing overlaps apart";

/** Serves the queries about motion. `threshold`: the least speed that bounces (m/s); `iterations`: of the solver. */
export function serveMotion(name, { threshold, iterations }, queries, settings) {
  const run = (scene, adjust) => {
    const world = newWorld(scene, threshold), { forces = [] } = scene.motion;
    const bodies = scene.bodies.map((body) => addTo(world, body));
    bodies.forEach((rigid) => { rigid.setSolverIterationCounts(...iterations); adjust(rigid); });
    const go = (from, to) => {
      const steps = Math.ceil((to - from) / step), dt = (to - from) / steps;
      for (let k = 0; k < steps; ++k) {
        bodies.forEach((rigid, i) => {
          if (scene.bodies[i].mass?.type === "fixed") drive(rigid, scene.bodies[i], from + (k + 1) * dt);
          else using(vector(forceAt(forces, i, from)), (f) => rigid.addForce(f)); // for one step
        });
        world.simulate(dt);
        world.fetchResults(true);
      }
    };
    try {
      return { states: sampled(scene.motion, go, () => bodies.map(state)) };
    } finally {
      bodies.forEach((rigid) => rigid.release());
      world.release();
    }
  };
  const simulation = (scene) => {
    requireOffered(scene);
    return run(scene, () => {});
  };
  // A shorter step would turn the rounding of friction's anchors into speed.
  const impulse = (scene) => after(run(impactScene(scene, massOf, { seconds: step, overlap: 0 }), (rigid) => {
    rigid.setRigidBodyFlag(gyroscopic, false);
    rigid.setMaxDepenetrationVelocity(1e-10);
  }));
  const card = {
    name, version, precision: "binary32", about: `${about}; ${settings}`, homepage, stepping: { step, order: 1 },
    domain: { ...domain, angular_speed: 100 }, // limits as shipped
    dynamics: {
      restitution_threshold: threshold * (1 + 2 ** -20), // an approach of the threshold itself does not bounce
      speed_limits: { angular: 100 }, friction: "pyramid", // along each of two axes by itself
    },
  };
  const all = { impulse, simulation };
  serve(card, Object.fromEntries(queries.map((query) => [query, all[query]])));
}
