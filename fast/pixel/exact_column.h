// The exact depths of a convex part above the centre of a pixel, for the few pixels on which doubles cannot decide.
#pragma once

#include <optional>
#include <vector>

#include "fast/exact/vector.h"
#include "fast/pixel/posed_part.h"

namespace touchstone::fast::pixel {

/// num/den, den > 0.
struct Fraction {
  exact::Dyadic num;
  exact::Dyadic den;
};

/// The closed interval from lo − √spread to hi + √spread; spread is 0 for a polytope.
struct Column {
  Fraction lo;
  Fraction hi;
  Fraction spread;
};

/// Whether the two have a common depth.
bool meet(const Column& a, const Column& b);

/// A part in W: points are (M p + t)/D, where M, t and D are sums of products of doubles.
class ExactPart {
 public:
  explicit ExactPart(const Part& part);

  /// Nothing if the part is not above the centre.
  std::optional<Column> above(const exact::Dyadic& x, const exact::Dyadic& y) const;

 private:
  struct Side {
    exact::Vector normal;
    exact::Dyadic offset;  ///< normal·(D p) ≤ offset
  };

  exact::Dyadic D_;
  std::vector<Side> sides_;
  exact::Vector centre_;  ///< D times a sphere's centre
  double radius_ = 0;     ///< 0 for a polytope
};

}  // namespace touchstone::fast::pixel
