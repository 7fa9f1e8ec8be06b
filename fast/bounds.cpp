#include "fast/bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace touchstone::fast {
namespace {

// The error of one computed coordinate R_i·p + t_i, with s = ‖p‖₁ (|R_ij| ≤ 1) and γ_k = k u/(1 − k u):
//   the numerator of R_ij: at most 4 rounded products and 3 sums, its terms' magnitudes sum to ≤ |q|²        4.1 u |q|²
//   |q|² itself: 4 squares, 3 sums                                                                     relative 4.1 u
//   the quotient                                                                                        relative 1 u
//   three products and two sums with p                                                                      3.1 u s
//   + t_i                                                                                           1 u (s + |t_i|)
// together ≤ 13.4 u s + 1.1 u |t_i|; then the outward step itself rounds once, 1.1 u (s + |t_i|). So 16 u (s + |t|∞)
// covers it with room for the rounding of this very bound. A compound's part is posed twice: its rotation and offset
// are rounded before they are rounded again, so its bound is taken twice, and its offset counts with the terms that it
// is a sum of. Underflow loses at most 2^-1075 an operation.
constexpr double u = 0x1p-53;
constexpr double coordinate_error = 16 * u;
constexpr double underflow = 0x1p-1070;

/// Lengths are worked with as multiples of 2^8, so that no sum of a few of them overflows.
constexpr double unit = 0x1p8;

/// q scaled by a power of two until its greatest component is in [1, 2): the same rotation, and |q|² stays in range.
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

/// p ↦ R p + t in multiples of `unit`. `offsets` is the size of the terms that t is a sum of, `poses` how many were
/// chained.
struct Motion {
  Mat3 R;
  Vec3 t;
  double offsets;
  int poses;
};

Motion motion(const Pose& X) {
  const Vec3 t = X.p_WB / unit;
  return {rotation(X.q_WB), t, t.lpNorm<Eigen::Infinity>(), 1};
}

Motion composed(const Motion& outer, const Motion& inner) {
  return {outer.R * inner.R, outer.R * inner.t + outer.t, outer.offsets + inner.t.lpNorm<1>(), 2};
}

/// Grows while it sees points; in multiples of `unit`.
class Grower {
 public:
  /// The points within `reach` (along W's axes) of R p + t; `length` is ‖·‖₁ in the shape's own frame, as derived
  /// above.
  void add(const Motion& X, const Vec3& p, const Vec3& reach, double length) {
    const Vec3 centre = X.R * p + X.t;
    const double size = length + X.offsets;
    const Vec3 outward = reach + Vec3::Constant(X.poses * coordinate_error * size + underflow);
    lo_ = lo_.cwiseMin(centre - outward);
    hi_ = hi_.cwiseMax(centre + outward);
  }

  Aabb box() const {
    constexpr double greatest = std::numeric_limits<double>::max();
    return {(lo_ * unit).cwiseMax(-greatest), (hi_ * unit).cwiseMin(greatest)};
  }

 private:
  Vec3 lo_ = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 hi_ = Vec3::Constant(-std::numeric_limits<double>::infinity());
};

void grow(Grower& grower, const Sphere& sphere, const Motion& X) {
  const double radius = sphere.radius / unit;
  grower.add(X, Vec3::Zero(), Vec3::Constant(radius), radius);
}

/// Each half extent reaches |R_ij| h_j along axis i.
void grow(Grower& grower, const Box& box, const Motion& X) {
  const Vec3 half = box.half_extents / unit;
  grower.add(X, Vec3::Zero(), X.R.cwiseAbs() * half, half.lpNorm<1>());
}

void grow(Grower& grower, const Polytope& polytope, const Motion& X) {
  for (const Vec3& vertex : polytope.vertices) {
    const Vec3 p = vertex / unit;
    grower.add(X, p, Vec3::Zero(), p.lpNorm<1>());
  }
}

void grow(Grower& grower, const Compound& compound, const Motion& X_WB) {
  for (const Part& part : compound.parts) {
    const Motion X_WP = composed(X_WB, motion(part.X_BP));
    std::visit([&](const auto& shape) { grow(grower, shape, X_WP); }, part.shape);
  }
}

}  // namespace

Aabb box(const Body& body) {
  Grower grower;
  std::visit([&](const auto& shape) { grow(grower, shape, motion(body.X_WB)); }, body.shape);
  return grower.box();
}

Bounds bounds(const Scene& scene) {
  Bounds boxes;
  boxes.reserve(scene.bodies.size());
  for (const Body& body : scene.bodies) boxes.push_back(box(body));
  return boxes;
}

}  // namespace touchstone::fast
