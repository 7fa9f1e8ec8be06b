// Boxes that grow point by point, rounded outward; all kinds of bounds are made with them.
#pragma once

#include "fast/rounding.h"
#include "model/frame.h"
#include "model/infinity.h"
#include "model/shape.h"

namespace touchstone::fast::outward {

/// Lengths are handled as multiples of 2^8, so that no sum of a few of them overflows. All internal interfaces of this
/// folder use this unit.
constexpr double unit = 0x1p8;

// The error of one computed coordinate R_i·p + t_i, with s = ‖p‖₁ (|R_ij| ≤ 1) and γ_k = k u/(1 − k u):
//   the numerator of R_ij: at most 4 rounded products and 3 sums, its terms' magnitudes sum to ≤ |q|²      4.1 u |q|²
//   |q|² itself: 4 squares, 3 sums                                                                   relative 4.1 u
//   the quotient                                                                                       relative 1 u
//   three products and two sums with p                                                                      3.1 u s
//   + t_i                                                                                           1 u (s + |t_i|)
// Together ≤ 13.4 u s + 1.1 u |t_i|; then the outward step itself rounds once, 1.1 u (s + |t_i|). So 16 u (s + |t|∞)
// covers it, with room for the rounding of this bound. A compound's part is posed twice: its rotation and offset are
// already rounded when they are rounded again, so its bound is doubled, and its offset is added to the terms of its
// sum. Underflow loses at most 2^-1075 per operation.
constexpr double coordinate_error = 16 * u;
constexpr double underflow = 0x1p-1070;

/// p ↦ R p + t. `offsets`: the magnitude of the terms that t is a sum of; `poses`: how many poses were composed.
struct Motion {
  Mat3 R = Mat3::Identity();
  Vec3 t = Vec3::Zero();
  double offsets = 0;
  int poses = 0;
};

Motion motion(const Pose& X);
Motion composed(const Motion& outer, const Motion& inner);

/// Bound on the error of a computed R p + t, per axis; `length` is ‖p‖₁.
inline double place_error(const Motion& X, double length) {
  return X.poses * coordinate_error * (length + X.offsets) + underflow;
}

class Grower {
 public:
  /// Adds the points within `reach` (along W's axes) of R p + t; `length` is ‖·‖₁ in the shape's own frame, as derived
  /// above.
  void add(const Motion& X, const Vec3& p, const Vec3& reach, double length);

  /// Sweeps the box by all displacements from lo to hi.
  void stretch(const Vec3& lo, const Vec3& hi);

  /// In metres. An end beyond the range of doubles is the greatest finite double.
  Aabb box() const;

 private:
  Vec3 lo_ = Vec3::Constant(infinity);
  Vec3 hi_ = Vec3::Constant(-infinity);
};

/// Adds one vertex of a polytope.
void grow(Grower& grower, const Vec3& vertex, const Motion& X);
void grow(Grower& grower, const Sphere& sphere, const Motion& X);
void grow(Grower& grower, const Box& box, const Motion& X);
void grow(Grower& grower, const Polytope& polytope, const Motion& X);
void grow(Grower& grower, const Compound& compound, const Motion& X_WB);

}  // namespace touchstone::fast::outward
