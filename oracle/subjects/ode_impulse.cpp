#include "oracle/subjects/ode_impulse.h"

#include <ode/ode.h>

#include "oracle/subjects/impact_input.h"

namespace touchstone::oracle::subjects {
namespace {

constexpr bool is_double = sizeof(dReal) == sizeof(double);

dReal real(double x) { return static_cast<dReal>(x); }

/// A body about its centre of mass, with ODE's own masses for densities; none if fixed.
dBodyID make_body(dWorldID world, const Body& body) {
  if (is_fixed(body)) return nullptr;
  const dBodyID made = dBodyCreate(world);
  const Pose X = centre_of_mass(body);
  const Eigen::Quaterniond q = unit_quaternion(X.q_WB);
  const dQuaternion turn = {real(q.w()), real(q.x()), real(q.y()), real(q.z())};
  dBodySetPosition(made, real(X.p_WB.x()), real(X.p_WB.y()), real(X.p_WB.z()));
  dBodySetQuaternion(made, turn);
  const Vec3 &v = body.velocity.v_WBcm, &w = body.velocity.w_WB;
  dBodySetLinearVel(made, real(v.x()), real(v.y()), real(v.z()));
  dBodySetAngularVel(made, real(w.x()), real(w.y()), real(w.z()));
  dBodySetGyroscopicMode(made, 0);  // the step is an impact's: no spin of its own in between
  dMass mass;
  if (const auto* given = std::get_if<MassProperties>(&body.mass)) {
    const Mat3& I = given->I_BBcm_B;
    dMassSetParameters(&mass, real(given->mass), 0, 0, 0, real(I(0, 0)), real(I(1, 1)), real(I(2, 2)), real(I(0, 1)),
                       real(I(0, 2)), real(I(1, 2)));
  } else {
    const dReal density = real(std::get<Density>(body.mass).value);
    if (const auto* sphere = std::get_if<Sphere>(&body.shape)) {
      dMassSetSphere(&mass, density, real(sphere->radius));
    } else {
      const Vec3 sides = 2 * std::get<Box>(body.shape).half_extents;
      dMassSetBox(&mass, density, real(sides.x()), real(sides.y()), real(sides.z()));
    }
  }
  dBodySetMass(made, &mass);
  return made;
}

/// Friction as a coefficient (dContactApprox1), not as a greatest force; the normal points into the first body.
dContact made_of(const Contact& contact) {
  dContact it{};
  it.surface.mode = dContactBounce | dContactApprox1;
  it.surface.bounce = real(contact.restitution);
  it.surface.bounce_vel = 0;
  it.surface.mu = real(contact.friction);  // infinity is dInfinity
  it.geom.depth = 0;
  for (int i = 0; i < 3; ++i) {
    it.geom.pos[i] = real(contact.p_WC[i]);
    it.geom.normal[i] = real(contact.nhat_BA_W[i]);
  }
  return it;
}

Velocity velocity_of(dBodyID body) {
  if (body == nullptr) return {};
  const dReal *v = dBodyGetLinearVel(body), *w = dBodyGetAngularVel(body);
  return {{v[0], v[1], v[2]}, {w[0], w[1], w[2]}};
}

struct Library {
  Library() { dInitODE(); }
  ~Library() { dCloseODE(); }
};

class OdeImpulse : public Subject {
 public:
  explicit OdeImpulse(const std::string& stepper) : step_(stepper == "step" ? &dWorldStep : &dWorldQuickStep) {
    static const Library library;
    card_.name = "ode." + stepper;
    card_.version = dODE_VERSION;
    card_.precision = is_double ? Precision::binary64 : Precision::binary32;
    card_.answers = {"impulse"};
    card_.about = std::string(stepper == "step" ? "dWorldStep" : "dWorldQuickStep") +
                  " by 1/64 s over one contact joint: dContactBounce, bounce_vel 0, dContactApprox1, depth 0, CFM 0 "
                  "(its default is 1e-10), no gyroscopic term";
    card_.homepage = "https://ode.org";
  }

  const Card& card() const override { return card_; }

  Answer<Impulse> impulse(const Scene& scene) override {
    if (const auto declined = no_such_impact(scene)) return *declined;
    const dWorldID world = dWorldCreate();
    dWorldSetCFM(world, 0);
    const dBodyID A = make_body(world, scene.bodies[0]), B = make_body(world, scene.bodies[1]);
    const dContact contact = made_of(*scene.contact);
    const dJointID joint = dJointCreateContact(world, nullptr, &contact);
    dJointAttach(joint, A, B);
    step_(world, real(1.0 / 64));
    Impulse said;
    said.after = {velocity_of(A), velocity_of(B)};
    dWorldDestroy(world);
    return said;
  }

 private:
  int (*step_)(dWorldID, dReal);
  Card card_;
};

}  // namespace

std::unique_ptr<Subject> make_ode_impulse(const std::string& stepper) { return std::make_unique<OdeImpulse>(stepper); }

}  // namespace touchstone::oracle::subjects
