// The penetration depth of two convex bodies, with a certified enclosure and an exact verdict.
#pragma once

#include <memory>

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::fast {

/// What is said of two bodies; lengths in m, directions in W.
struct PenetrationDepth {
  Penetration answer;  ///< verdict and depth, and the direction if the bodies overlap
  Interval enclosure;  ///< of the exact depth; [0, 0] unless they overlap
};

/// For bodies 0 (A) and 1 (B); depth and direction as in docs/spec/penetration.md.
///
/// Laws: `enclosure` contains the exact depth; the verdict is exact; the depth lies in the enclosure. Moving A by the
/// depth along the direction, of length 1 within 4u, separates the two within rounding. Where the cores overlap, the
/// depth is found by expanding a polytope inside B − A, in doubles (fast/penetration/depth_bracket.h) and, if their
/// bounds are wider than rounding explains, in exact arithmetic (fast/penetration/exact_depth.h). Otherwise it is that
/// of the radii beyond the nearest points of the cores.
///
/// Of a polytope only the vertices are read, so its faces need not be given. Throws InputError for fewer than two
/// bodies and for compounds, whose depth is another problem; std::range_error if the depth or the distance is beyond
/// doubles.
PenetrationDepth penetration_depth(const Scene& scene);

/// The same for two bodies that are followed over time: the polytope of one pose starts the search at the next.
class PenetrationPair {
 public:
  /// Requires valid shapes. Throws InputError for compounds.
  PenetrationPair(const Shape& A, const Shape& B);
  ~PenetrationPair();

  /// Requires valid poses. Throws std::range_error as penetration_depth does.
  PenetrationDepth at(const Pose& X_WA, const Pose& X_WB);

 private:
  struct Kept;

  std::unique_ptr<Kept> kept_;
};

}  // namespace touchstone::fast
