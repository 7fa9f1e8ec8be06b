#include "oracle/subjects/simbody/stepper.h"

#include <algorithm>

#include "oracle/subjects/simbody/muted.h"
#include "oracle/subjects/simbody/parts.h"

namespace touchstone::oracle::subjects::in_simbody {
namespace {

/// m/s: below twice this Simbody restores no approach and treats slip as rolling. A user of Simbody sets it for the
/// motion at hand, so it is a share of the greatest speed that a body has at C.
double tolerance(const std::array<RigidBody, 2>& bodies, const PointContact& contact) {
  double fastest = 0;
  for (const RigidBody& body : bodies) {
    const double lever = (contact.p_WC - body.p_WBcm).stableNorm();
    fastest = std::max(fastest, body.v_WBcm.stableNorm() + body.w_WB.stableNorm() * lever);
  }
  return fastest > 0 ? 0x1p-40 * fastest : 0x1p-40;
}

/// s: the step in which the faster body turns by 2⁻¹⁰⁰ rad, which changes ω by less than one digit; no longer than if
/// it turned by 1 rad/s.
double step(const std::array<RigidBody, 2>& bodies) {
  return 0x1p-100 / std::max({1.0, bodies[0].w_WB.stableNorm(), bodies[1].w_WB.stableNorm()});
}

/// C as a vertex of A in contact with a plane of B: the only contact of Simbody that takes any point and any normal.
/// The scene says that the bodies are in contact, so Simbody's tolerance does not matter.
class ThisContact : public SimTK::PointPlaneContact {
 public:
  using PointPlaneContact::PointPlaneContact;
  bool isProximal(const SimTK::State&, double) const override { return true; }
};

ThisContact* made_of(const PointContact& contact, const std::array<RigidBody, 2>& bodies, SimTK::MobilizedBody& A,
                     SimTK::MobilizedBody& B) {
  const SimTK::Transform X_WA = frame_of(bodies[0]), X_WB = frame_of(bodies[1]);
  const SimTK::Vec3 p_WC = vector(contact.p_WC);
  const SimTK::Vec3 p_AC = ~X_WA.R() * (p_WC - X_WA.p()), p_BC = ~X_WB.R() * (p_WC - X_WB.p());
  const SimTK::UnitVec3 nhat_B(~X_WB.R() * vector(contact.nhat_BA_W));
  return new ThisContact(B, nhat_B, dot(p_BC, nhat_B), A, p_AC, contact.e, contact.mu, contact.mu, 0);
}

}  // namespace

std::array<Twist, 2> impact(const std::array<RigidBody, 2>& bodies, const PointContact& contact) {
  const Muted muted;
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter(system);
  SimTK::MobilizedBody A = put(bodies[0], matter), B = put(bodies[1], matter);
  matter.adoptUnilateralContact(made_of(contact, bodies, A, B));
  SimTK::State state = system.realizeTopology();
  start(bodies[0], A, state);
  start(bodies[1], B, state);
  Stepper stepper(system);
  stepper.setRestitutionModel(contact.restitution == Restitution::newton ? Stepper::Newton : Stepper::Poisson);
  stepper.setPositionProjectionMethod(Stepper::NoPositionProjection);
  stepper.setConstraintTolerance(tolerance(bodies, contact));
  stepper.initialize(state);
  stepper.stepTo(step(bodies));
  system.realize(stepper.getState(), SimTK::Stage::Velocity);
  return {twist_of(A, stepper.getState()), twist_of(B, stepper.getState())};
}

std::string version() {
  int major, minor, build;
  SimTK_version_simbody(&major, &minor, &build);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(build);
}

}  // namespace touchstone::oracle::subjects::in_simbody
