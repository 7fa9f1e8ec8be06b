#include "oracle/subjects/ode/impulse.h"

#include "oracle/subject.h"
#include "oracle/subjects/ode/input.h"

namespace touchstone::oracle::subjects {
namespace {

using namespace in_ode;

/// None for a fixed body.
dBodyID make_body(dWorldID world, const Body& body) {
  if (is_fixed(body)) return nullptr;
  const dBodyID made = put(world, body);
  dBodySetGyroscopicMode(made, 0);  // the step only resolves an impact, so ω must not change by itself
  const dMass mass = mass_of(body);
  dBodySetMass(made, &mass);
  return made;
}

/// Friction is a coefficient (dContactApprox1), not a maximum force. ODE's normal points into the first body.
dContact made_of(const Contact& contact) {
  dContact it{};
  it.surface.mode = dContactBounce | dContactApprox1;
  it.surface.bounce = real(contact.restitution);
  it.surface.bounce_vel = 0;
  it.surface.mu = real(contact.friction);  // infinity becomes dInfinity
  it.geom.depth = 0;
  for (int i = 0; i < 3; ++i) {
    it.geom.pos[i] = real(contact.p_WC[i]);
    it.geom.normal[i] = real(contact.nhat_BA_W[i]);
  }
  return it;
}

class OdeImpulse : public Subject {
 public:
  explicit OdeImpulse(const std::string& stepper) : step_(stepper == "step" ? &dWorldStep : &dWorldQuickStep) {
    card_ = in_ode::card(stepper,
                         std::string(stepper == "step" ? "dWorldStep" : "dWorldQuickStep") +
                             " by 1/64 s over one contact joint: dContactBounce, bounce_vel 0, dContactApprox1, depth "
                             "0, CFM 0 (its default is 1e-10), no gyroscopic term");
    card_.answers = {"impulse"};
    card_.dynamics.friction_pyramid = true;
  }

  const Card& card() const override { return card_; }

  Answer<Impulse> impulse(const Scene& scene) override {
    if (const auto declined = no_such_impact(scene)) return *declined;
    start_random_numbers();
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
