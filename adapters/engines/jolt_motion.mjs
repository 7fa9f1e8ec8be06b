// Jolt's simulation: a world with the bodies of a scene, in equal steps of at most `step` between sample times.
import { serve, sub, unitQuaternion } from "../js/touchstone_adapter.mjs";
import { after, impactScene } from "./impact_scene.mjs";
import {
  JOLT, distance_tolerance, domain, homepage, list, made, massOf, newWorld, shapeOf, vector, version,
} from "./jolt_bodies.mjs";
import { forceAt, requireOffered, sampled, step } from "./sampled_motion.mjs";

const quaternion = (q) => (({ w, x, y, z }) => new JOLT.Quat(x, y, z, w))(unitQuaternion(q));

/** Calls `use` with a value that is destroyed afterwards. */
function using(value, use) {
  try {
    return use(value);
  } finally {
    JOLT.destroy(value);
  }
}

/** A body's shape, whose centre of mass Jolt computes, or moves to where it is given. */
function wholeShape({ shape, mass }) {
  const density = mass?.density ?? 1, compound = new JOLT.StaticCompoundShapeSettings();
  for (const { shape: part, X_BP } of shape.type === "compound" ? shape.parts : []) {
    const one = shapeOf(part, density);
    using(vector(X_BP.p), (p) => using(quaternion(X_BP.q), (q) => compound.AddShapeShape(p, q, one, 0)));
    one.Release();
  }
  const whole = shape.type === "compound" ? made(compound) : shapeOf(shape, density);
  if (!mass || mass.type === "density") return whole;
  const offset = sub(mass.p_BBcm ?? [0, 0, 0], list(whole.GetCenterOfMass())); // a fixed body turns about its origin
  const moved = using(vector(offset), (by) => new JOLT.OffsetCenterOfMassShape(whole, by));
  moved.AddRef();
  whole.Release();
  return moved;
}

function setMass(settings, { mass, I_BBcm_B: I }) {
  settings.mOverrideMassProperties = JOLT.EOverrideMassProperties_MassAndInertiaProvided;
  settings.mMassPropertiesOverride.mMass = mass;
  I.forEach((column, i) => using(vector(column), (v) => settings.mMassPropertiesOverride.mInertia.SetColumn3(i, v)));
}

function addTo(world, body, gyroscopic) {
  const { v_WBcm = [0, 0, 0], w_WB = [0, 0, 0] } = body.velocity ?? {};
  const kind = body.mass?.type === "fixed" ? JOLT.EMotionType_Kinematic : JOLT.EMotionType_Dynamic;
  const shape = wholeShape(body), bodies = world.GetPhysicsSystem().GetBodyInterface();
  const settings = using(vector(body.X_WB.p), (p) => using(quaternion(body.X_WB.q), (q) =>
    new JOLT.BodyCreationSettings(shape, p, q, kind, 0)));
  shape.Release(); // the settings hold it
  if (body.mass?.type === "given") setMass(settings, body.mass);
  settings.mRestitution = body.material?.restitution ?? 0;
  settings.mFriction = body.material?.friction ?? 0;
  settings.mLinearDamping = settings.mAngularDamping = 0;
  settings.mAllowSleeping = false;
  settings.mApplyGyroscopicForce = gyroscopic;
  using(vector(v_WBcm), (v) => { settings.mLinearVelocity = v; });
  using(vector(w_WB), (w) => { settings.mAngularVelocity = w; });
  const rigid = bodies.CreateBody(settings);
  JOLT.destroy(settings);
  bodies.AddBody(rigid.GetID(), JOLT.EActivation_Activate);
  return rigid;
}

/** Jolt takes the greater e and the geometric mean of mu; a contact listener sets the lesser ones. */
function combineByMin() {
  const listener = new JOLT.ContactListenerJS();
  listener.OnContactValidate = () => JOLT.ValidateResult_AcceptAllContactsForThisBodyPair;
  listener.OnContactAdded = listener.OnContactPersisted = (one, other, manifold, settings) => {
    const [A, B] = [one, other].map((body) => JOLT.wrapPointer(body, JOLT.Body));
    const contact = JOLT.wrapPointer(settings, JOLT.ContactSettings);
    contact.mCombinedRestitution = Math.min(A.GetRestitution(), B.GetRestitution());
    contact.mCombinedFriction = Math.min(A.GetFriction(), B.GetFriction());
  };
  listener.OnContactRemoved = () => {};
  return listener;
}

const listener = combineByMin();

const state = (rigid) => {
  const q = rigid.GetRotation();
  return { X_WB: { p: list(rigid.GetPosition()), q: { w: q.GetW(), x: q.GetX(), y: q.GetY(), z: q.GetZ() } },
    velocity: { v_WBcm: list(rigid.GetLinearVelocity()), w_WB: list(rigid.GetAngularVelocity()) } };
};

/** Calls `use` with a world that has the scene's gravity and `tune`d settings. */
function inWorldOf(scene, tune, use) {
  const world = newWorld(), system = world.GetPhysicsSystem(), settings = system.GetPhysicsSettings();
  tune(settings);
  system.SetPhysicsSettings(settings);
  using(vector(scene.gravity ?? [0, 0, 0]), (g) => system.SetGravity(g));
  system.SetContactListener(listener);
  return using(world, use);
}

const about = "JoltInterface.Step, equal steps of at most 1/256 s between sample times, convex radius 0, without "
  + "damping and sleep, with the gyroscopic term, e and mu of a pair the lesser; impulse is asked of two balls of "
  + "radius 1, without that term";

const limits = { speed: 500, angular_speed: 47.1 }; // as shipped

/** Serves the queries about motion, with an overlap that is left alone (m), and the least speed that bounces (m/s). */
export function serveMotion(name, { slop, threshold }, settings) {
  const tune = (to) => Object.assign(to, { mPenetrationSlop: slop, mMinVelocityForRestitution: threshold });
  const run = (scene, gyroscopic) => inWorldOf(scene, tune, (world) => {
    const bodies = scene.bodies.map((body) => addTo(world, body, gyroscopic)), { forces = [] } = scene.motion;
    const go = (from, to) => {
      const steps = Math.ceil((to - from) / step);
      for (let k = 0; k < steps; ++k) {
        bodies.forEach((rigid, i) => using(vector(forceAt(forces, i, from)), (f) => rigid.AddForce(f))); // for one step
        world.Step((to - from) / steps, 1);
      }
    };
    return { states: sampled(scene.motion, go, () => bodies.map(state)) };
  });
  const simulation = (scene) => {
    requireOffered(scene);
    return run(scene, true);
  };
  const impulse = (scene) => after(run(impactScene(scene, massOf), false)); // the term's rounding would count
  const card = {
    name, version, precision: "binary32", about: `${about}; ${settings}`, homepage, stepping: { step, order: 1 },
    domain: { ...domain, ...limits },
    dynamics: {
      restitution_threshold: threshold * (1 + 2 ** -20), // an approach of the threshold itself does not bounce
      speed_limits: { linear: limits.speed, angular: limits.angular_speed },
    },
    distance_tolerance: { ...distance_tolerance, slop },
  };
  serve(card, { impulse, simulation });
}
