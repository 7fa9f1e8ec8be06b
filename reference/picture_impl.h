// The projection of a convex solid along z, and whether it meets a square.
#pragma once

#include <gmpxx.h>

#include <vector>

#include "reference/half_space_impl.h"

namespace touchstone::reference {

/// Closed, with sides along the axes, perhaps of length 0.
struct Rectangle {
  long x_lo, x_hi, y_lo, y_hi;
};

/// The hull of some points' projections: a polygon, a segment, a point, or nothing.
///
/// Two convex sets in the plane, one of them a polygon (or less) and the other a rectangle, are apart exactly if an
/// edge of one of them has them on its two sides: so a list of half-planes, the axes' included, settles it.
class Picture {
 public:
  explicit Picture(const std::vector<Triple>& points);

  bool meets(const Rectangle& square) const;

 private:
  struct HalfPlane {
    mpz_class a, b, c;  ///< a x + b y + c ≥ 0
  };
  void add(const mpq_class& a, const mpq_class& b, const mpq_class& c);

  bool empty_;
  std::vector<HalfPlane> sides_;
};

}  // namespace touchstone::reference
