#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <memory>
#include <optional>

#include "tests/bench/bullet_shape.h"
#include "tests/bench/time_of_impact/casting.h"

namespace touchstone::bench {
namespace {

btTransform turned(const Pose& X) {
  btTransform placed = bullet_transform(X);
  placed.setRotation(placed.getRotation().normalized());
  return placed;
}

struct Pair {
  explicit Pair(const Scene& given)
      : A(bullet_hull(std::get<Polytope>(given.bodies[0].shape))),
        B(bullet_hull(std::get<Polytope>(given.bodies[1].shape))) {}

  std::optional<double> cast(const oracle::subjects::Way& way) {
    btConvexCast::CastResult result;
    btContinuousConvexCollision collision(A.get(), B.get(), &simplex, &epa);
    const bool hit =
        collision.calcTimeOfImpact(turned(way.from_A), turned(way.to_A), turned(way.from_B), turned(way.to_B), result);
    return hit && result.m_fraction <= 1 ? std::optional<double>(result.m_fraction) : std::nullopt;
  }

  std::unique_ptr<btConvexHullShape> A, B;
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver epa;
};

}  // namespace

std::vector<Entrant> bullet() { return {{"Bullet double", "peer", casting<Pair>}}; }

}  // namespace touchstone::bench
