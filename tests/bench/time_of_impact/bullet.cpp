#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <memory>
#include <optional>
#include <variant>

#include "oracle/subjects/common/cast.h"
#include "tests/bench/bullet_shape.h"
#include "tests/bench/time_of_impact/contestant.h"

namespace touchstone::bench {
namespace {

btTransform turned(const Pose& X) {
  btTransform placed = bullet_transform(X);
  placed.setRotation(placed.getRotation().normalized());
  return placed;
}

struct Pair {
  explicit Pair(const Scene& given)
      : scene(given),
        A(bullet_hull(std::get<Polytope>(given.bodies[0].shape))),
        B(bullet_hull(std::get<Polytope>(given.bodies[1].shape))) {}

  std::optional<double> cast(const oracle::subjects::Way& way) {
    btConvexCast::CastResult result;
    btContinuousConvexCollision collision(A.get(), B.get(), &simplex, &epa);
    const bool hit =
        collision.calcTimeOfImpact(turned(way.from_A), turned(way.to_A), turned(way.from_B), turned(way.to_B), result);
    return hit && result.m_fraction <= 1 ? std::optional<double>(result.m_fraction) : std::nullopt;
  }

  Scene scene;
  std::unique_ptr<btConvexHullShape> A, B;
  btVoronoiSimplexSolver simplex;
  btGjkEpaPenetrationDepthSolver epa;
};

Ask prepared(const Scene& scene) {
  return [pair = std::make_shared<Pair>(scene)] {
    const auto cast = [&](const oracle::subjects::Way& way) { return pair->cast(way); };
    return std::get<TimeOfImpact>(oracle::subjects::cast_along(pair->scene, true, cast));
  };
}

}  // namespace

std::vector<Entrant> bullet() { return {{"Bullet double", "peer", prepared}}; }

}  // namespace touchstone::bench
