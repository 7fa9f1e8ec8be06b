#include "oracle/subjects/simbody/rigid_bodies.h"

#include "oracle/subjects/simbody/muted.h"
#include "oracle/subjects/simbody/parts.h"

namespace touchstone::oracle::subjects::in_simbody {

struct RigidBodies::Parts {
  Muted muted;
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter{system};
  SimTK::GeneralForceSubsystem forces{system};
  SimTK::Force::DiscreteForces pushes{forces, matter};
  std::vector<SimTK::MobilizedBody> bodies;
  std::vector<RigidBody> given;
  std::unique_ptr<Stepper> stepper;

  /// Simbody 3.7 ignores the height of a contact's plane, so each plane gets a frame of its own.
  SimTK::MobilizedBody standing(const Face& face) {
    const SimTK::Rotation R_WF(SimTK::UnitVec3(vector(face.nhat_W)), SimTK::ZAxis);
    return SimTK::MobilizedBody::Weld(matter.updGround(), SimTK::Transform(R_WF, vector(face.p_WF)),
                                      SimTK::Body::Massless(), SimTK::Transform());
  }

  void declare(const OnFace& it) {
    SimTK::MobilizedBody plane = standing(it.face);
    const SimTK::UnitVec3 normal(SimTK::ZAxis);
    const double e = it.pair.e, mu = it.pair.mu;
    SimTK::UnilateralContact* contact = nullptr;
    if (it.radius > 0) {
      contact =
          new SimTK::SpherePlaneContact(plane, normal, 0, bodies[it.body], vector(it.p_BC), it.radius, e, mu, mu, 0);
    } else {
      contact = new SimTK::PointPlaneContact(plane, normal, 0, bodies[it.body], vector(it.p_BC), e, mu, mu, 0);
    }
    matter.adoptUnilateralContact(contact);
  }

  /// The centre of a ball in the frame of its Simbody body; for a fixed ball that is the world frame.
  SimTK::Vec3 centre(std::size_t body) const {
    return given[body].mass == 0 ? vector(given[body].p_WBcm) : SimTK::Vec3(0);
  }

  void declare(const BallOnBall& it) {
    matter.adoptUnilateralContact(new SimTK::SphereSphereContact(bodies[it.a], centre(it.a), it.radius_a, bodies[it.b],
                                                                 centre(it.b), it.radius_b, it.pair.e, it.pair.mu,
                                                                 it.pair.mu, 0));
  }
};

RigidBodies::RigidBodies(const std::vector<RigidBody>& bodies, const std::vector<OnFace>& on_faces,
                         const std::vector<BallOnBall>& on_balls, const Eigen::Vector3d& gravity,
                         Restitution restitution)
    : parts_(std::make_unique<Parts>()) {
  Parts& parts = *parts_;
  parts.given = bodies;
  SimTK::Force::UniformGravity(parts.forces, parts.matter, vector(gravity));
  for (const RigidBody& body : bodies) parts.bodies.push_back(put(body, parts.matter));
  for (const OnFace& contact : on_faces) parts.declare(contact);
  for (const BallOnBall& contact : on_balls) parts.declare(contact);
  SimTK::State state = parts.system.realizeTopology();
  for (std::size_t i = 0; i < bodies.size(); ++i) start(bodies[i], parts.bodies[i], state);
  parts.stepper = std::make_unique<Stepper>(parts.system);
  parts.stepper->setRestitutionModel(restitution == Restitution::newton ? Stepper::Newton : Stepper::Poisson);
  parts.stepper->initialize(state);
}

RigidBodies::~RigidBodies() = default;

void RigidBodies::step(double seconds, const std::vector<Eigen::Vector3d>& forces_W) {
  SimTK::State& state = parts_->stepper->updState();
  for (std::size_t i = 0; i < forces_W.size(); ++i) {
    const SimTK::MobilizedBody& body = parts_->bodies[i];
    if (!body.isGround()) parts_->pushes.setOneBodyForce(state, body, {SimTK::Vec3(0), vector(forces_W[i])});
  }
  parts_->stepper->stepTo(state.getTime() + seconds);
}

Place RigidBodies::place(std::size_t i) const {
  const RigidBody& given = parts_->given[i];
  if (given.mass == 0) return {given.p_WBcm, given.q_WB, {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()}};
  const SimTK::State& state = parts_->stepper->getState();
  parts_->system.realize(state, SimTK::Stage::Velocity);
  const SimTK::MobilizedBody& body = parts_->bodies[i];
  const SimTK::Vec4 q = body.getBodyRotation(state).convertRotationToQuaternion().asVec4();
  return {vector(body.getBodyOriginLocation(state)), {q[0], q[1], q[2], q[3]}, twist_of(body, state)};
}

}  // namespace touchstone::oracle::subjects::in_simbody
