// Converts scenes to Bullet's types. Include it in this folder only: its meaning depends on the precision that Bullet
// is built for.
#pragma once

#include <btBulletCollisionCommon.h>

#include <memory>

#include "oracle/subjects/common/customary_domain.h"
#include "oracle/subjects/common/engine.h"

namespace touchstone::oracle::subjects::in_bullet {

inline constexpr bool is_double = sizeof(btScalar) == sizeof(double);

/// For the cards; the reason: docs/how_to/add_a_subject.md.
inline Domain domain() {
  Domain made = customary_domain();
  made.lengths = Interval{0.05, 10};
  made.fixed_lengths = Interval{0, 1e30};  // nothing is said of them
  return made;
}

inline btScalar scalar(double x) { return static_cast<btScalar>(x); }
inline btVector3 vector(const Vec3& v) { return {scalar(v.x()), scalar(v.y()), scalar(v.z())}; }
inline Vec3 vec3(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

inline btTransform transform(const Pose& X_WB) {
  const Eigen::Quaterniond q = rotation(X_WB.q_WB);
  return btTransform(btQuaternion(scalar(q.x()), scalar(q.y()), scalar(q.z()), scalar(q.w())), vector(X_WB.p_WB));
}

using ConvexPtr = std::unique_ptr<btConvexShape>;

/// The collision margin is set to 0 before anything is computed with it. A sphere's margin is its radius and stays.
struct MakeShape {
  ConvexPtr operator()(const Sphere& sphere) const { return std::make_unique<btSphereShape>(scalar(sphere.radius)); }
  ConvexPtr operator()(const Box& box) const {
    auto shape = std::make_unique<btBoxShape>(vector(box.half_extents));
    shape->setMargin(0);
    return shape;
  }
  ConvexPtr operator()(const Polytope& polytope) const {
    auto shape = std::make_unique<btConvexHullShape>();
    shape->setMargin(0);
    for (const Vec3& vertex : polytope.vertices) shape->addPoint(vector(vertex), false);
    shape->recalcLocalAabb();
    return shape;
  }
  ConvexPtr operator()(const Compound&) const { return nullptr; }
};

}  // namespace touchstone::oracle::subjects::in_bullet
