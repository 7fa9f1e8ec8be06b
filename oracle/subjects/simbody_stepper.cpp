#include "oracle/subjects/simbody_stepper.h"

#include <fcntl.h>
#include <simbody/Simbody.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>

namespace touchstone::oracle::subjects::in_simbody {
namespace {

using Stepper = SimTK::SemiExplicitEulerTimeStepper;

constexpr double tolerance =
    0x1p-40;                       ///< m/s; Simbody restores no approach below twice this, and calls such slip rolling
constexpr double step = 0x1p-100;  ///< s; Simbody's spins turn in a step: in one this short, by less than a digit

/// Debian builds Simbody with its tracing on, some 20 kB of stdout a step. What was printed before still comes out.
class Muted {
 public:
  Muted() : stdout_(redirect(open("/dev/null", O_WRONLY | O_CLOEXEC))) {}
  ~Muted() { close(redirect(stdout_)); }
  Muted(const Muted&) = delete;
  Muted& operator=(const Muted&) = delete;

 private:
  /// Takes `to`; returns what stdout was.
  static int redirect(int to) {
    std::fflush(stdout);
    std::cout.flush();
    const int was = dup(STDOUT_FILENO);
    dup2(to, STDOUT_FILENO);
    close(to);
    return was;
  }

  int stdout_;
};

SimTK::Vec3 vector(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
Eigen::Vector3d vector(const SimTK::Vec3& v) { return {v[0], v[1], v[2]}; }

SimTK::MassProperties mass_of(const RigidBody& body) {
  const SimTK::Vec3 centre(0);
  if (const auto* I = std::get_if<Eigen::Matrix3d>(&body.moments)) {
    return {body.mass, centre, SimTK::Inertia((*I)(0, 0), (*I)(1, 1), (*I)(2, 2), (*I)(0, 1), (*I)(0, 2), (*I)(1, 2))};
  }
  if (const auto* ball = std::get_if<BallOf>(&body.moments)) {
    return {body.mass, centre, SimTK::UnitInertia::sphere(ball->radius)};
  }
  return {body.mass, centre, SimTK::UnitInertia::brick(vector(std::get<BrickOf>(body.moments).half_extents))};
}

/// Frames are at centres of mass, so that no inertia is moved; the ground's is the world's.
SimTK::Transform frame_of(const RigidBody& body) {
  if (body.mass == 0) return {};
  const Eigen::Quaterniond& q = body.q_WB;
  return {SimTK::Rotation(SimTK::Quaternion(q.w(), q.x(), q.y(), q.z())), vector(body.p_WBcm)};
}

SimTK::MobilizedBody put(const RigidBody& body, SimTK::SimbodyMatterSubsystem& matter) {
  if (body.mass == 0) return matter.updGround();
  return SimTK::MobilizedBody::Free(matter.updGround(), SimTK::Body::Rigid(mass_of(body)));
}

void start(const RigidBody& body, const SimTK::MobilizedBody& mobilized, SimTK::State& state) {
  if (body.mass == 0) return;
  mobilized.setQToFitTransform(state, frame_of(body));
  mobilized.setUToFitVelocity(state, {vector(body.w_WB), vector(body.v_WBcm)});
}

Twist twist_of(const SimTK::MobilizedBody& body, const SimTK::State& state) {
  return {vector(body.getBodyOriginVelocity(state)), vector(body.getBodyAngularVelocity(state))};
}

/// C as a vertex of A that meets a plane of B: the one contact of Simbody that takes any point and any normal. That
/// they meet is the scene's to say, and not a matter of Simbody's tolerance.
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
  stepper.setConstraintTolerance(tolerance);
  stepper.initialize(state);
  stepper.stepTo(step);
  system.realize(stepper.getState(), SimTK::Stage::Velocity);
  return {twist_of(A, stepper.getState()), twist_of(B, stepper.getState())};
}

std::string version() {
  int major, minor, build;
  SimTK_version_simbody(&major, &minor, &build);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(build);
}

}  // namespace touchstone::oracle::subjects::in_simbody
