// The projection of a convex solid along z, and whether it intersects a rectangle.
#pragma once

#include <gmpxx.h>

#include <vector>

#include "reference/hull/half_space.h"

namespace touchstone::reference {

/// A closed rectangle with sides parallel to the axes, perhaps of length 0.
struct Rectangle {
  long x_lo, x_hi, y_lo, y_hi;
};

/// The hull of the projections of some points: a polygon, a segment, a point, or empty.
///
/// Two convex sets in the plane, one of them a polygon (or less) and the other a rectangle, are apart exactly if the
/// line through an edge of one of them separates them. So a list of half-planes that includes the axis directions
/// decides it.
class Projection {
 public:
  explicit Projection(const std::vector<Triple>& points);

  bool intersects(const Rectangle& square) const;

 private:
  struct HalfPlane {
    mpz_class a, b, c;  ///< a x + b y + c ≥ 0
  };
  void add(const mpq_class& a, const mpq_class& b, const mpq_class& c);

  bool empty_;
  std::vector<HalfPlane> sides_;
};

}  // namespace touchstone::reference
