// The six extremal vertices of a turning polytope, found from those of the frame before.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "fast/lin_canny/hull.h"

namespace touchstone::fast {

/// Of all vertices, the highest along ±x, ±y, ±z of W; of several as high, the one with the lexicographically greatest
/// coordinates in the hull's own frame. So there is one answer, whatever vertex the climb starts from: the order is
/// that of the linear function h + εx + ε²y + ε³z for small ε > 0, whose local maximum on a convex solid is the only
/// one.
///
/// Heights are compared exactly: an edge's computed direction decides while its height is further from 0 than rounding
/// explains, and sums of doubles without rounding decide else. (A local maximum of rounded heights is no global one.)
///
/// Cost: the edges at the vertices passed, O(1) between coherent frames. Source: Cohen, Lin, Manocha & Ponamgi 1995.
class Climb {
 public:
  /// Along +x, +y, +z, −x, −y, −z.
  using Six = std::array<int, 6>;

  /// Bodies of one shape may share the hull. Requires `start` to be a vertex of it.
  explicit Climb(std::shared_ptr<const lin_canny::Hull> hull, int start = 0);

  /// `poses` from the outermost in: one for a body, two for a part of a compound. R: their rotations' product as
  /// computed, within 36u of the exact one (‖·‖₂, fast/lin_canny/solid.cpp).
  const Six& climb(std::span<const Pose> poses, const Mat3& R);

  const lin_canny::Hull& hull() const { return *hull_; }

 private:
  std::shared_ptr<const lin_canny::Hull> hull_;
  Six six_;
};

}  // namespace touchstone::fast
