#include "oracle/subjects/bullet/simulation.h"

#include <btBulletDynamicsCommon.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "oracle/subject.h"
#include "oracle/subjects/bullet/input.h"
#include "oracle/subjects/common/impact_input.h"
#include "oracle/subjects/common/simulation_world.h"

namespace touchstone::oracle::subjects {
namespace {

using namespace in_bullet;

Eigen::Quaterniond quaternion(const btQuaternion& q) { return {q.w(), q.x(), q.y(), q.z()}; }

/// Mass properties of a body that is not fixed. Bullet takes inertia in principal axes, about the frame's origin.
struct MassFrame {
  double mass = 0;
  std::optional<Vec3> moments;  ///< none: computed by Bullet
  Pose X_BE;                    ///< pose of the principal axes E at the centre of mass
};

MassFrame mass_frame(const Body& body) {
  if (const auto* density = std::get_if<Density>(&body.mass)) return {density->value * volume(body.shape), {}, {}};
  const auto& given = std::get<MassProperties>(body.mass);
  const Mat3& I = given.I_BBcm_B;
  if (I.isDiagonal(0)) return {given.mass, I.diagonal(), {given.p_BBcm, {}}};
  const Eigen::SelfAdjointEigenSolver<Mat3> principal(I);
  Mat3 R_BE = principal.eigenvectors();
  R_BE.col(2) = R_BE.col(0).cross(R_BE.col(1));
  const Eigen::Quaterniond q(R_BE);
  return {given.mass, principal.eigenvalues(), {given.p_BBcm, {q.w(), q.x(), q.y(), q.z()}}};
}

/// A body with a prescribed velocity. Bullet derives its velocity from its poses after successive steps.
class Driven : public btMotionState {
 public:
  explicit Driven(const Body& body) : now_(transform(body.X_WB)), velocity_(body.velocity) {}

  void drive(btScalar seconds) {
    btTransform next;
    btTransformUtil::integrateTransform(now_, vector(velocity_.v_WBcm), vector(velocity_.w_WB), seconds, next);
    now_ = next;
  }
  void getWorldTransform(btTransform& X_WB) const override { X_WB = now_; }
  void setWorldTransform(const btTransform&) override {}

 private:
  btTransform now_;
  Velocity velocity_;
};

class RigidBody {
 public:
  explicit RigidBody(const Body& body) {
    const MassFrame mass = is_fixed(body) ? MassFrame{} : mass_frame(body);
    X_BE_ = mass.X_BE;
    make_shape(body.shape);
    btVector3 moments(0, 0, 0);
    if (mass.moments) moments = vector(*mass.moments);
    if (mass.mass > 0 && !mass.moments) shape_->calculateLocalInertia(scalar(mass.mass), moments);
    btRigidBody::btRigidBodyConstructionInfo info(scalar(mass.mass), nullptr, shape_, moments);
    info.m_startWorldTransform = transform(body.X_WB) * transform(X_BE_);
    info.m_restitution = scalar(body.material.restitution);
    info.m_friction = scalar(body.material.friction);
    body_ = std::make_unique<btRigidBody>(info);
    body_->setActivationState(DISABLE_DEACTIVATION);
    if (!is_fixed(body)) {
      body_->setLinearVelocity(vector(body.velocity.v_WBcm));
      body_->setAngularVelocity(vector(body.velocity.w_WB));
    } else if (!(body.velocity == Velocity{})) {
      drive(body);
    }
  }

  btRigidBody* get() const { return body_.get(); }

  void begin_step(double seconds, const Vec3& force_W) {
    if (driven_) driven_->drive(scalar(seconds));
    body_->applyCentralForce(vector(force_W));
  }

  State state() const {
    const btTransform& X_WE = body_->getWorldTransform();
    return {pose_of_body(vec3(X_WE.getOrigin()), quaternion(X_WE.getRotation()), X_BE_),
            {vec3(body_->getLinearVelocity()), vec3(body_->getAngularVelocity())}};
  }

 private:
  void drive(const Body& body) {
    driven_ = std::make_unique<Driven>(body);
    body_->setMotionState(driven_.get());
    body_->setCollisionFlags(body_->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
  }

  /// A convex shape whose frame is E is used directly; any other shape becomes a child of a compound.
  void make_shape(const Shape& shape) {
    const auto* compound = std::get_if<Compound>(&shape);
    if (compound == nullptr && X_BE_ == Pose{}) {
      parts_.push_back(std::visit(MakeShape{}, shape));
      shape_ = parts_.back().get();
      return;
    }
    const btTransform X_EB = transform(X_BE_).inverse();
    if (compound == nullptr) {
      add_child(X_EB, std::visit(MakeShape{}, shape));
    } else {
      for (const Part& part : compound->parts) {
        add_child(X_EB * transform(part.X_BP), std::visit(MakeShape{}, part.shape));
      }
    }
    shape_ = &children_;
  }

  void add_child(const btTransform& X_EP, ConvexPtr part) {
    children_.addChildShape(X_EP, part.get());
    parts_.push_back(std::move(part));
  }

  Pose X_BE_;
  std::vector<ConvexPtr> parts_;
  btCompoundShape children_;
  btCollisionShape* shape_ = nullptr;
  std::unique_ptr<Driven> driven_;
  std::unique_ptr<btRigidBody> body_;
};

class World : public SimulationWorld {
 public:
  World(const Scene& scene, bool tuned) {
    world_.setGravity(vector(scene.gravity));
    if (tuned) tune(world_.getSolverInfo());
    for (const Body& body : scene.bodies) {
      bodies_.push_back(std::make_unique<RigidBody>(body));
      if (tuned) bodies_.back()->get()->setContactProcessingThreshold(0);
      world_.addRigidBody(bodies_.back()->get());
    }
  }
  ~World() override {
    for (const auto& body : bodies_) world_.removeRigidBody(body->get());
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  void step(double seconds, const std::vector<Vec3>& forces_W) override {
    for (std::size_t i = 0; i < bodies_.size(); ++i) bodies_[i]->begin_step(seconds, forces_W[i]);
    world_.stepSimulation(scalar(seconds), 0);
  }

  State state(int body) const override { return bodies_[static_cast<std::size_t>(body)]->state(); }

 private:
  static void tune(btContactSolverInfo& info) {
    info.m_restitutionVelocityThreshold = 0;
    info.m_solverMode &= ~SOLVER_USE_WARMSTARTING;
    info.m_linearSlop = 0;
    info.m_splitImpulse = 1;
    info.m_splitImpulsePenetrationThreshold = 0;
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broad_phase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broad_phase_, &solver_, &configuration_};
  std::vector<std::unique_ptr<RigidBody>> bodies_;
};

/// Bullet's documented way to replace its products of coefficients: here, the minimum of the two.
void combine_by_the_lesser() {
  gCalculateCombinedRestitutionCallback = [](const btCollisionObject* a, const btCollisionObject* b) {
    return btMin(a->getRestitution(), b->getRestitution());
  };
  gCalculateCombinedFrictionCallback = [](const btCollisionObject* a, const btCollisionObject* b) {
    return btMin(a->getFriction(), b->getFriction());
  };
}

class BulletSimulation : public Subject {
 public:
  BulletSimulation(const std::string& settings, double dt) : tuned_(settings == "simulation_tuned"), dt_(dt) {
    card_.name = std::string(is_double ? "bullet." : "bullet.float_") + settings;
    card_.version = std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100);
    card_.precision = is_double ? Precision::binary64 : Precision::binary32;
    card_.answers = {"simulation"};
    card_.stepping = Stepping{dt, 1};
    card_.about =
        "btDiscreteDynamicsWorld, equal steps of at most 1/" + std::to_string(std::lround(1 / dt)) +
        " s between sample times, margins 0, sleeping disabled, e and mu of a pair the lesser; " +
        (tuned_ ? "restitution threshold 0, no warm starting, processing threshold 0, slop 0, split impulse from "
                  "penetration 0 on"
                : "settings as shipped: restitution from 0.2 m/s on");
    if (!tuned_) card_.dynamics.restitution_threshold = btContactSolverInfo().m_restitutionVelocityThreshold;
    card_.dynamics.angular_speed_limit =
        ANGULAR_MOTION_THRESHOLD / dt;  // a body that should turn farther in a step turns less
    card_.domain = domain();
    card_.homepage = "https://github.com/bulletphysics/bullet3";
    combine_by_the_lesser();
  }

  const Card& card() const override { return card_; }

  Answer<Trajectory> simulation(const Scene& scene) override {
    if (const auto declined = no_such_motion(scene)) return *declined;
    for (const Body& body : scene.bodies) {
      if (std::isinf(body.material.friction)) return Abstains{"infinite friction is not offered"};
    }
    World world(scene, tuned_);
    return follow(scene, dt_, world);
  }

 private:
  bool tuned_;
  double dt_;
  Card card_;
};

}  // namespace

std::unique_ptr<Subject> make_bullet_simulation(const std::string& settings) {
  return make_bullet_simulation(settings, default_step);
}

std::unique_ptr<Subject> make_bullet_simulation(const std::string& settings, double dt) {
  return std::make_unique<BulletSimulation>(settings, dt);
}

}  // namespace touchstone::oracle::subjects
