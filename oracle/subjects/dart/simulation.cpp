#include "oracle/subjects/dart/simulation.h"

#include <algorithm>
#include <cmath>
#include <dart/config.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/SphereShape.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <dart/simulation/World.hpp>

#include "oracle/subject.h"
#include "oracle/subjects/common/customary_domain.h"
#include "oracle/subjects/common/impact_input.h"
#include "oracle/subjects/common/simulation_world.h"

namespace touchstone::oracle::subjects {
namespace {

namespace dynamics = dart::dynamics;

Eigen::Isometry3d transform(const Pose& X) {
  Eigen::Isometry3d made = Eigen::Isometry3d::Identity();
  made.linear() = rotation(X.q_WB).toRotationMatrix();
  made.translation() = X.p_WB;
  return made;
}

struct MakeShape {
  dynamics::ShapePtr operator()(const Sphere& sphere) const {
    return std::make_shared<dynamics::SphereShape>(sphere.radius);
  }
  dynamics::ShapePtr operator()(const Box& box) const {
    return std::make_shared<dynamics::BoxShape>(2 * box.half_extents);
  }
  dynamics::ShapePtr operator()(const auto&) const { return nullptr; }  // declined earlier
};

dynamics::Inertia inertia(const Body& body) {
  if (const auto* given = std::get_if<MassProperties>(&body.mass)) return {given->mass, given->p_BBcm, given->I_BBcm_B};
  const double mass = std::get<Density>(body.mass).value * volume(body.shape);
  return {mass, Vec3::Zero(), std::visit(MakeShape{}, parts_of(body.shape)[0].shape)->computeInertia(mass)};
}

/// DART multiplies the two restitutions, so a pair has the scene's one value if each body has its root.
void add_shapes(dynamics::BodyNode& node, const Body& body) {
  for (const Part& part : parts_of(body.shape)) {
    auto* const shape =
        node.createShapeNodeWith<dynamics::VisualAspect, dynamics::CollisionAspect, dynamics::DynamicsAspect>(
            std::visit(MakeShape{}, part.shape));
    shape->setRelativeTransform(transform(part.X_BP));
    shape->getDynamicsAspect()->setRestitutionCoeff(std::sqrt(body.material.restitution));
    shape->getDynamicsAspect()->setFrictionCoeff(body.material.friction);
  }
}

dynamics::BodyNode* free_body(dynamics::Skeleton& skeleton, const Body& body) {
  const auto [joint, node] = skeleton.createJointAndBodyNodePair<dynamics::FreeJoint>();
  node->setInertia(inertia(body));
  joint->setTransform(transform(body.X_WB));
  // DART's velocity is that of the body's origin.
  const Vec3 p_BcmB_W = -(rotation(body.X_WB.q_WB) * node->getLocalCOM());
  joint->setAngularVelocity(body.velocity.w_WB);
  joint->setLinearVelocity(body.velocity.v_WBcm + body.velocity.w_WB.cross(p_BcmB_W));
  return node;
}

dynamics::BodyNode* fixed_body(dynamics::Skeleton& skeleton, const Body& body) {
  const auto [joint, node] = skeleton.createJointAndBodyNodePair<dynamics::WeldJoint>();
  joint->setTransformFromParentBodyNode(transform(body.X_WB));
  return node;
}

class World : public SimulationWorld {
 public:
  explicit World(const Scene& scene) : scene_(scene) {
    world_->setGravity(scene.gravity);
    for (const Body& body : scene.bodies) {
      const dynamics::SkeletonPtr skeleton = dynamics::Skeleton::create();
      bodies_.push_back(is_fixed(body) ? fixed_body(*skeleton, body) : free_body(*skeleton, body));
      add_shapes(*bodies_.back(), body);
      world_->addSkeleton(skeleton);
    }
  }

  void step(double seconds, const std::vector<Vec3>& forces_W) override {
    world_->setTimeStep(seconds);
    for (std::size_t i = 0; i < bodies_.size(); ++i) bodies_[i]->addExtForce(forces_W[i], bodies_[i]->getLocalCOM());
    world_->step();
  }

  State state(int i) const override {
    const Body& body = scene_.bodies[static_cast<std::size_t>(i)];
    if (is_fixed(body)) return {body.X_WB, {}};
    const dynamics::BodyNode& moved = *bodies_[static_cast<std::size_t>(i)];
    const Eigen::Isometry3d& X_WB = moved.getTransform();
    return {pose_of_body(X_WB.translation(), Eigen::Quaterniond(X_WB.linear()), {}),
            {moved.getCOMLinearVelocity(), moved.getAngularVelocity()}};
  }

 private:
  const Scene& scene_;
  dart::simulation::WorldPtr world_ = dart::simulation::World::create();
  std::vector<dynamics::BodyNode*> bodies_;
};

class DartSimulation : public Subject {
 public:
  explicit DartSimulation(double dt) : dt_(dt) {
    card_.name = "dart.simulation";
    card_.version = DART_VERSION;
    card_.answers = {"simulation"};
    card_.about = "dart::simulation::World, equal steps of at most 1/" + std::to_string(std::lround(1 / dt)) +
                  " s between sample times; each body has the root of the scene's restitution, since DART multiplies "
                  "the two of a pair; detector (FCL) and solver (Dantzig) as shipped";
    card_.homepage = "https://dartsim.github.io";
    card_.domain = customary_domain();
    card_.stepping = Stepping{dt, 1};
    card_.dynamics.friction_pyramid = true;
    // Constants of its contacts that it does not offer: measured, a ball at 0.09 m/s does not bounce, one at 0.11 m/s
    // does, and one at 150 m/s leaves at 100 m/s.
    card_.dynamics.restitution_threshold = 0.1;
    card_.dynamics.speed_limit = 100;
  }

  const Card& card() const override { return card_; }

  Answer<Trajectory> simulation(const Scene& scene) override {
    if (const auto declined = no_such_motion(scene)) return *declined;
    for (const Body& body : scene.bodies) {
      if (has_hull(body)) return Abstains{"a hull would be a mesh of assimp"};
      if (is_fixed(body) && !(body.velocity == Velocity{})) return Abstains{"moving fixed bodies are not offered"};
      if (body.material.restitution != scene.bodies[0].material.restitution)
        return Abstains{"the restitution of a pair is the product of two"};
    }
    World world(scene);
    return follow(scene, dt_, world);
  }

 private:
  double dt_;
  Card card_;
};

}  // namespace

std::unique_ptr<Subject> make_dart_simulation() { return make_dart_simulation(default_step); }

std::unique_ptr<Subject> make_dart_simulation(double dt) { return std::make_unique<DartSimulation>(dt); }

}  // namespace touchstone::oracle::subjects
