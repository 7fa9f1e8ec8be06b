// The smallest scene that still fails: fewest bodies, then fewest frames of its sequence, then vertices, then bits.
#pragma once

#include <functional>

#include "model/scene.h"

namespace touchstone::oracle {

/// Tries the moves of oracle/minimise/shrink.h, stage after stage, until none helps or still_fails has been called
/// `budget` times. Every scene that it tries, and the one that it returns, is valid, has its faces, and costs less than
/// the last one that failed. Deterministic if still_fails is. Requires a completed scene that fails.
Scene minimise(const Scene& scene, const std::function<bool(const Scene&)>& still_fails, int budget);

struct Size {
  int bodies = 0;
  int vertices_per_body_max = 0;  ///< of all parts of a body; a box has 8, a sphere 1
  int significant_bits_max = 0;   ///< of a length or a quaternion's component

  bool operator==(const Size&) const = default;
};

Size size_of(const Scene& scene);

}  // namespace touchstone::oracle
