// The six extremal vertices of a rotating polytope, computed from those of the previous frame.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "fast/lin_canny/hull.h"

namespace touchstone::fast {

/// The highest vertices along ±x, ±y, ±z of W; among equally high ones, that with the lexicographically greatest
/// coordinates in the hull's own frame. This makes the result independent of the starting vertex: the order is that of
/// the linear function h + εx + ε²y + ε³z for small ε > 0, which has a single local maximum on a convex solid.
///
/// Heights are compared exactly: an edge's computed direction decides if its slope exceeds its rounding error, and
/// otherwise sums of doubles without rounding. (A local maximum of rounded heights need not be the global one.)
///
/// Cost: the edges at the vertices passed, O(1) between coherent frames. Source: Cohen, Lin, Manocha & Ponamgi 1995.
class Climb {
 public:
  /// Along +x, +y, +z, −x, −y, −z.
  using Six = std::array<int, 6>;

  /// Bodies of one shape may share the hull. Requires `start` to be one of its vertices.
  explicit Climb(std::shared_ptr<const lin_canny::Hull> hull, int start = 0);

  /// `poses`: the outermost first; one for a body, two for a part of a compound. R: the computed product of their
  /// rotations, within 36u of the exact one (‖·‖₂, fast/lin_canny/solid.cpp).
  const Six& climb(std::span<const Pose> poses, const Mat3& R);

  const lin_canny::Hull& hull() const { return *hull_; }

 private:
  std::shared_ptr<const lin_canny::Hull> hull_;
  Six six_;
};

}  // namespace touchstone::fast
