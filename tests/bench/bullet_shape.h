// What the comparisons with Bullet in double precision share.
#pragma once

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>

#include <memory>

#include "model/scene.h"

namespace touchstone::bench {

/// With margin 0.
inline std::unique_ptr<btConvexHullShape> bullet_hull(const Polytope& polytope) {
  auto shape = std::make_unique<btConvexHullShape>();
  for (const Vec3& v : polytope.vertices) shape->addPoint({v.x(), v.y(), v.z()}, false);
  shape->recalcLocalAabb();
  shape->setMargin(0);
  return shape;
}

inline btTransform bullet_transform(const Pose& X) {
  const Quaternion& q = X.q_WB;
  return btTransform(btQuaternion(q.x, q.y, q.z, q.w), btVector3(X.p_WB.x(), X.p_WB.y(), X.p_WB.z()));
}

}  // namespace touchstone::bench
