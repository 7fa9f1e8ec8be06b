// The distance of two bodies by Lin & Canny's closest features, with a certified enclosure and an exact verdict.
#pragma once

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::fast {

/// Of bodies 0 (A) and 1 (B); d* and r as in docs/spec/distance.md.
///
/// Laws: `enclosure` holds the exact distance; the verdict is exact; `distance` lies in the enclosure and is > 0
/// exactly when separated. Where bodies overlap, both witnesses are one common point (of the cores or within the
/// radii), and no features are named.
///
/// Requires a valid scene of at least two bodies whose polytopes have their faces. Throws InputError naming what is
/// wrong, and std::range_error if the distance is beyond the greatest double.
///
/// Cost: preparing the shapes O(n log n), walking from a corner; for a pair followed through time, fast/collider.h.
Distance distance(const Scene& scene);

}  // namespace touchstone::fast
