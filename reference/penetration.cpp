#include "reference/penetration.h"

#include <Eigen/Geometry>
#include <utility>

#include "model/input_error.h"
#include "reference/distance/routes.h"
#include "reference/exact/float_mode.h"
#include "reference/exact/rational.h"
#include "reference/exact/square_root.h"
#include "reference/penetration/routes.h"

namespace touchstone::reference {
namespace {

void point_along(const IntegerVec& v, PenetrationTruth& truth) {
  const Integer common = gcd(gcd(v.x, v.y), v.z);
  const auto reduced = [&](const Integer& x) { return rational(mpq_class(Integer(x / common))); };
  truth.direction = {reduced(v.x), reduced(v.y), reduced(v.z)};
  const PlainVec about = plain(v);
  truth.nhat_BA_W = Vec3(about.x, about.y, about.z).normalized();
}

/// Requires cores with a common point that have common interior, or a positive radius.
void measure_depth(PosedPair& pair, DepthRoute route, PenetrationTruth& truth) {
  truth.cores_overlap = true;
  if (pair.A.is_point() && pair.B.is_point()) {
    point_along({1, 0, 0}, truth);
  } else {
    const CoreDepth depth = route == DepthRoute::gauss_map ? depth_by_gauss_map(pair) : depth_by_minkowski_hull(pair);
    truth.core_squared = pair.square(Integer(depth.gap * depth.gap), dot(depth.normal, depth.normal));
    point_along(-depth.normal, truth);
  }
  truth.depth = enclosure_of_root_minus(truth.core_squared, -truth.radius_sum);
}

PenetrationTruth truth_of(PosedPair& pair, DepthRoute route) {
  const DefaultFloatMode mode;
  const CoreNearest nearest = nearest_certified(pair);
  PenetrationTruth truth;
  truth.radius_sum = Rational(pair.A.radius()) + Rational(pair.B.radius());
  if (is_zero(nearest.normal)) {
    if (nearest.cores == Verdict::touching) point_along(nearest.direction, truth);
    truth.verdict = truth.radius_sum.sign() > 0 ? Verdict::overlapping : nearest.cores;
    if (truth.verdict == Verdict::overlapping) measure_depth(pair, route, truth);
    return truth;
  }
  truth.core_squared = squared_distance(pair, nearest);
  point_along(nearest.normal, truth);
  const Rational excess = truth.core_squared - truth.radius_sum * truth.radius_sum;
  if (excess.sign() == 0) truth.verdict = Verdict::touching;
  if (excess.sign() < 0) {
    truth.verdict = Verdict::overlapping;
    truth.depth = enclosure_of_minus_root(truth.radius_sum, truth.core_squared);
  }
  return truth;
}

PosedPair convex_pair(const Scene& scene, const Vec3& shift_A) {
  if (scene.bodies.size() < 2) throw InputError("bodies", "two are needed for a penetration depth");
  for (std::size_t i = 0; i < 2; ++i) {
    if (!std::holds_alternative<Compound>(scene.bodies[i].shape)) continue;
    throw InputError("bodies[" + std::to_string(i) + "].shape",
                     "a compound has no depth here: the body must be convex");
  }
  return PosedPair(scene.bodies[0], 0, scene.bodies[1], 0, shift_A);
}

}  // namespace

void Shallowest::offer(IntegerVec normal, Integer gap) {
  const Integer length_squared = dot(normal, normal);
  const Integer gap_squared = gap * gap;
  if (!is_zero(best_.normal) && gap_squared * length_squared_ >= gap_squared_ * length_squared) return;
  best_ = {std::move(normal), std::move(gap)};
  gap_squared_ = gap_squared;
  length_squared_ = length_squared;
}

PenetrationTruth penetration(const Scene& scene, DepthRoute route) {
  PosedPair pair = convex_pair(scene, Vec3::Zero());
  return truth_of(pair, route);
}

Interval depth_after(const Scene& scene, const Vec3& translation) {
  PosedPair pair = convex_pair(scene, translation);
  return truth_of(pair, DepthRoute::gauss_map).depth;
}

}  // namespace touchstone::reference
