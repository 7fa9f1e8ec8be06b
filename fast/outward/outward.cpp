#include "fast/outward/outward.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace touchstone::fast::outward {
namespace {

/// q is scaled by a power of two until its greatest component is in [1, 2): the same rotation, and |q|² stays in range.
Mat3 rotation(const Quaternion& q) {
  const double greatest = std::max({std::abs(q.w), std::abs(q.x), std::abs(q.y), std::abs(q.z)});
  const int shift = -std::ilogb(greatest);
  const double w = std::scalbn(q.w, shift);
  const double x = std::scalbn(q.x, shift);
  const double y = std::scalbn(q.y, shift);
  const double z = std::scalbn(q.z, shift);
  Mat3 R;
  R << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y),  //
      2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x),   //
      2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z;
  return R / (w * w + x * x + y * y + z * z);
}

}  // namespace

Motion motion(const Pose& X) {
  const Vec3 t = X.p_WB / unit;
  return {rotation(X.q_WB), t, t.lpNorm<Eigen::Infinity>(), 1};
}

Motion composed(const Motion& outer, const Motion& inner) {
  return {outer.R * inner.R, outer.R * inner.t + outer.t, outer.offsets + inner.t.lpNorm<1>(), 2};
}

void Grower::add(const Motion& X, const Vec3& p, const Vec3& reach, double length) {
  const Vec3 centre = X.R * p + X.t;
  const Vec3 outward = reach + Vec3::Constant(place_error(X, length));
  lo_ = lo_.cwiseMin(centre - outward);
  hi_ = hi_.cwiseMax(centre + outward);
}

/// One sum rounds by u(|lo_| + |lo|), and the outward step by as much again.
void Grower::stretch(const Vec3& lo, const Vec3& hi) {
  const Vec3 step_lo = 4 * u * (lo_.cwiseAbs() + lo.cwiseAbs());
  const Vec3 step_hi = 4 * u * (hi_.cwiseAbs() + hi.cwiseAbs());
  lo_ = (lo_ + lo) - (step_lo + Vec3::Constant(underflow));
  hi_ = (hi_ + hi) + (step_hi + Vec3::Constant(underflow));
}

Aabb Grower::box() const {
  constexpr double greatest = std::numeric_limits<double>::max();
  return {(lo_ * unit).cwiseMax(-greatest), (hi_ * unit).cwiseMin(greatest)};
}

void grow(Grower& grower, const Vec3& vertex, const Motion& X) {
  const Vec3 p = vertex / unit;
  grower.add(X, p, Vec3::Zero(), p.lpNorm<1>());
}

void grow(Grower& grower, const Sphere& sphere, const Motion& X) {
  const double radius = sphere.radius / unit;
  grower.add(X, Vec3::Zero(), Vec3::Constant(radius), radius);
}

/// Each half extent contributes |R_ij| h_j along axis i.
void grow(Grower& grower, const Box& box, const Motion& X) {
  const Vec3 half = box.half_extents / unit;
  grower.add(X, Vec3::Zero(), X.R.cwiseAbs() * half, half.lpNorm<1>());
}

void grow(Grower& grower, const Polytope& polytope, const Motion& X) {
  for (const Vec3& vertex : polytope.vertices) grow(grower, vertex, X);
}

void grow(Grower& grower, const Compound& compound, const Motion& X_WB) {
  for (const Part& part : compound.parts) {
    const Motion X_WP = composed(X_WB, motion(part.X_BP));
    std::visit([&](const auto& shape) { grow(grower, shape, X_WP); }, part.shape);
  }
}

}  // namespace touchstone::fast::outward
