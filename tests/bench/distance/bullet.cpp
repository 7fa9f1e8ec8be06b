#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include "tests/bench/distance/contestant.h"

namespace touchstone::bench {
namespace {

std::unique_ptr<btConvexHullShape> hull(const Polytope& polytope) {
  auto shape = std::make_unique<btConvexHullShape>();
  for (const Vec3& v : polytope.vertices) shape->addPoint({v.x(), v.y(), v.z()}, false);
  shape->recalcLocalAabb();
  shape->setMargin(0);
  return shape;
}

btTransform transform(const Pose& X) {
  const Quaternion& q = X.q_WB;
  return btTransform(btQuaternion(q.x, q.y, q.z, q.w), btVector3(X.p_WB.x(), X.p_WB.y(), X.p_WB.z()));
}

/// btGjkPairDetector in double precision, margin 0. It starts from (0, 1, 0) every time.
class Bullet : public Contestant {
 public:
  Bullet(const Polytope& A, const Polytope& B)
      : A_(hull(A)), B_(hull(B)), detector_(A_.get(), B_.get(), &simplex_, &epa_) {}

  double distance(const FrameSequence::Poses& poses) override {
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = transform(poses.X_WA);
    input.m_transformB = transform(poses.X_WB);
    btPointCollector result;
    detector_.getClosestPoints(input, result, nullptr);
    return result.m_distance;
  }

 private:
  std::unique_ptr<btConvexHullShape> A_;
  std::unique_ptr<btConvexHullShape> B_;
  btVoronoiSimplexSolver simplex_;
  btGjkEpaPenetrationDepthSolver epa_;
  btGjkPairDetector detector_;
};

}  // namespace

std::vector<Entrant> bullet() {
  return {
      {"Bullet double", "peer", [](const Polytope& A, const Polytope& B) { return std::make_unique<Bullet>(A, B); }}};
}

}  // namespace touchstone::bench
