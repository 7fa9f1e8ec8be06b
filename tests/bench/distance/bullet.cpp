#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include "tests/bench/bullet_shape.h"
#include "tests/bench/distance/contestant.h"

namespace touchstone::bench {
namespace {

/// btGjkPairDetector in double precision, margin 0. It starts from (0, 1, 0) every time.
class Bullet : public Contestant {
 public:
  Bullet(const Polytope& A, const Polytope& B)
      : A_(bullet_hull(A)), B_(bullet_hull(B)), detector_(A_.get(), B_.get(), &simplex_, &epa_) {}

  double distance(const FrameSequence::Poses& poses) override {
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = bullet_transform(poses.X_WA);
    input.m_transformB = bullet_transform(poses.X_WB);
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
