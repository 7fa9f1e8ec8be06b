// The distance of two bodies by Lin & Canny's closest features, with a certified enclosure and an exact verdict.
#pragma once

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::fast {

/// For bodies 0 (A) and 1 (B); d* and r as in docs/spec/distance.md.
///
/// Laws: `enclosure` contains the exact distance; the verdict is exact; `distance` lies in the enclosure and is > 0
/// exactly when separated. If the bodies overlap, both witnesses are one common point (of the cores or within the
/// radii), and no features are named.
///
/// Requires a valid scene of at least two bodies whose polytopes have their faces. Throws InputError naming the
/// problem, and std::range_error if the distance exceeds the greatest double.
///
/// Cost: O(n log n) for preparing the shapes, and a walk that starts at a corner. For pairs followed over time, see
/// fast/collider.h.
Distance distance(const Scene& scene);

}  // namespace touchstone::fast
