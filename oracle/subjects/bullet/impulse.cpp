#include "oracle/subjects/bullet/impulse.h"

#include <btBulletDynamicsCommon.h>

#include <cmath>

#include "oracle/subject.h"
#include "oracle/subjects/bullet/input.h"
#include "oracle/subjects/common/impact_input.h"

namespace touchstone::oracle::subjects {
namespace {

using namespace in_bullet;

bool is_diagonal(const Mat3& I) { return I(0, 1) == 0 && I(0, 2) == 0 && I(1, 2) == 0; }

/// A rigid body in axes at its centre of mass. For a body with a density, Bullet expects its user to compute the mass,
/// and computes the moments itself.
class RigidBody {
 public:
  explicit RigidBody(const Body& body) : shape_(std::visit(MakeShape{}, body.shape)) {
    btVector3 moments(0, 0, 0);
    double mass = 0;
    if (const auto* given = std::get_if<MassProperties>(&body.mass)) {
      mass = given->mass;
      moments = vector(given->I_BBcm_B.diagonal());
    } else if (const auto* density = std::get_if<Density>(&body.mass)) {
      mass = density->value * volume(body.shape);
      shape_->calculateLocalInertia(scalar(mass), moments);
    }
    btRigidBody::btRigidBodyConstructionInfo info(scalar(mass), nullptr, shape_.get(), moments);
    info.m_startWorldTransform = transform(centre_of_mass(body));
    body_ = std::make_unique<btRigidBody>(info);
    body_->setFlags(0);  // no gyroscopic term: the step only resolves an impact
    if (is_fixed(body)) return;
    body_->setLinearVelocity(vector(body.velocity.v_WBcm));
    body_->setAngularVelocity(vector(body.velocity.w_WB));
  }

  btRigidBody* get() const { return body_.get(); }
  Velocity velocity() const { return {vec3(body_->getLinearVelocity()), vec3(body_->getAngularVelocity())}; }

 private:
  ConvexPtr shape_;
  std::unique_ptr<btRigidBody> body_;
};

/// The coefficients belong to the pair. They equal Bullet's products if one body has e and mu and the other has 1 and
/// 1.
btManifoldPoint point_of(const Contact& contact, const RigidBody& A, const RigidBody& B) {
  const btVector3 p_WC = vector(contact.p_WC), n = vector(contact.nhat_BA_W);
  const auto local = [&](const RigidBody& body) { return body.get()->getWorldTransform().invXform(p_WC); };
  btManifoldPoint point(local(A), local(B), n, 0);
  point.m_positionWorldOnA = point.m_positionWorldOnB = p_WC;
  point.m_combinedRestitution = scalar(contact.restitution);
  point.m_combinedFriction = scalar(contact.friction);
  return point;
}

class BulletImpulse : public Subject {
 public:
  explicit BulletImpulse(const std::string& settings) : tuned_(settings == "impulse_tuned") {
    card_.name = std::string(is_double ? "bullet." : "bullet.float_") + settings;
    card_.version = std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100);
    card_.precision = is_double ? Precision::binary64 : Precision::binary32;
    card_.answers = {"impulse"};
    card_.about =
        std::string("btSequentialImpulseConstraintSolver over one manifold point at distance 0, no gyroscopic term; ") +
        (tuned_ ? "restitution threshold 0, no warm starting, processing threshold 0, penetration threshold 0"
                : "settings as shipped: restitution from 0.2 m/s on");
    if (!tuned_) card_.dynamics.restitution_threshold = btContactSolverInfo().m_restitutionVelocityThreshold;
    card_.domain = domain();
    card_.homepage = "https://github.com/bulletphysics/bullet3";
    card_.deviations = {{"TS-IMPULSE-16", "restitution is lost in small steps",
                         "https://github.com/bulletphysics/bullet3/issues/4341"}};
  }

  const Card& card() const override { return card_; }

  Answer<Impulse> impulse(const Scene& scene) override {
    if (const auto declined = no_such_impact(scene)) return *declined;
    if (std::isinf(scene.contact->friction)) return Abstains{"infinite friction is not offered"};
    for (const Body& body : scene.bodies) {
      const auto* given = std::get_if<MassProperties>(&body.mass);
      if (given != nullptr && !is_diagonal(given->I_BBcm_B))
        return Abstains{"only a diagonal inertia tensor is offered"};
    }
    const RigidBody A(scene.bodies[0]), B(scene.bodies[1]);
    btContactSolverInfo info;
    const btScalar far = btScalar(BT_LARGE_FLOAT);
    btPersistentManifold manifold(A.get(), B.get(), 0, far, tuned_ ? 0 : far);
    manifold.addManifoldPoint(point_of(*scene.contact, A, B));
    if (tuned_) {
      info.m_restitutionVelocityThreshold = 0;
      info.m_solverMode &= ~SOLVER_USE_WARMSTARTING;
      info.m_splitImpulsePenetrationThreshold = 0;
    }
    btCollisionObject* bodies[] = {A.get(), B.get()};
    btPersistentManifold* manifolds[] = {&manifold};
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btSequentialImpulseConstraintSolver solver;
    solver.solveGroup(bodies, 2, manifolds, 1, nullptr, 0, info, nullptr, &dispatcher);
    Impulse said;
    said.after = {A.velocity(), B.velocity()};
    return said;
  }

 private:
  bool tuned_;
  Card card_;
};

}  // namespace

std::unique_ptr<Subject> make_bullet_impulse(const std::string& settings) {
  return std::make_unique<BulletImpulse>(settings);
}

}  // namespace touchstone::oracle::subjects
