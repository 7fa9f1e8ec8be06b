// The exact distance of the hulls of two posed point sets, for the few pairs on which doubles cannot decide.
#pragma once

#include <vector>

#include "fast/exact/difference.h"
#include "model/answers.h"

namespace touchstone::fast::exact {

/// The point d* of B − A nearest to 0, in the scale of a Difference (D its denominator):
///   separated    d* ≠ 0: `normal` is a positive multiple of d*, d* = Σ weights·(b − a) / Σ weights over `pairs`.
///   touching     d* = 0 likewise, and normal·(b − a) ≥ 0 for all vertices: no common interior point.
///   overlapping  d* = 0 likewise; the differences of `around` positively span space, so 0 is inside B − A.
/// Weights are positive, and there are one to three pairs; possibly four if the bodies overlap.
struct Nearest {
  Verdict verdict = Verdict::separated;
  Vector normal;
  std::vector<VertexPair> pairs;
  std::vector<Dyadic> weights;
  std::vector<VertexPair> around;
  Dyadic squared_times;  ///< D² |d*|² · squared_over
  Dyadic squared_over;   ///< > 0
};

/// Gilbert, Johnson & Keerthi's descent in exact arithmetic, from any vertex pairs to start with (at least one; a good
/// guess is fast). Terminates because |d*| of the current vertices decreases strictly, and there are finitely many sets
/// of them.
Nearest nearest(Difference& difference, std::vector<VertexPair> start);

}  // namespace touchstone::fast::exact
