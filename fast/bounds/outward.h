// Boxes that grow while they see points, rounded outward: what all kinds of bounds are made with.
#pragma once

#include <limits>

#include "fast/rounding.h"
#include "model/frame.h"
#include "model/shape.h"

namespace touchstone::fast::outward {

/// Lengths are worked with as multiples of 2^8, so that no sum of a few of them overflows. All that this folder's
/// inner parts say to each other is in this unit.
constexpr double unit = 0x1p8;

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
constexpr double coordinate_error = 16 * u;
constexpr double underflow = 0x1p-1070;

/// p ↦ R p + t. `offsets` is the size of the terms that t is a sum of, `poses` how many were chained.
struct Motion {
  Mat3 R = Mat3::Identity();
  Vec3 t = Vec3::Zero();
  double offsets = 0;
  int poses = 0;
};

Motion motion(const Pose& X);
Motion composed(const Motion& outer, const Motion& inner);

/// How far from the exact place R p + t may be computed, an axis; `length` is ‖p‖₁.
inline double place_error(const Motion& X, double length) {
  return X.poses * coordinate_error * (length + X.offsets) + underflow;
}

class Grower {
 public:
  /// The points within `reach` (along W's axes) of R p + t; `length` is ‖·‖₁ in the shape's own frame, as derived
  /// above.
  void add(const Motion& X, const Vec3& p, const Vec3& reach, double length);

  /// All that is in the box, moved by anything from lo to hi.
  void stretch(const Vec3& lo, const Vec3& hi);

  /// In metres. Where no double is large enough, the end is the greatest finite one.
  Aabb box() const;

 private:
  Vec3 lo_ = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 hi_ = Vec3::Constant(-std::numeric_limits<double>::infinity());
};

/// One vertex of a polytope.
void grow(Grower& grower, const Vec3& vertex, const Motion& X);
void grow(Grower& grower, const Sphere& sphere, const Motion& X);
void grow(Grower& grower, const Box& box, const Motion& X);
void grow(Grower& grower, const Polytope& polytope, const Motion& X);
void grow(Grower& grower, const Compound& compound, const Motion& X_WB);

}  // namespace touchstone::fast::outward
