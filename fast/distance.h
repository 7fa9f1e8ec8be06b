// The distance of two bodies and their closest features, with a certified enclosure and an exact verdict.
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
/// Requires a valid scene of at least two bodies, else throws InputError. Of a polytope only the vertices are read, so
/// its faces need not be given. Throws std::range_error if the distance exceeds the greatest double.
///
/// Cost: a few passes over the vertices of both; nothing is prepared. For pairs followed over time, see
/// fast/collider.h.
Distance distance(const Scene& scene);

}  // namespace touchstone::fast
