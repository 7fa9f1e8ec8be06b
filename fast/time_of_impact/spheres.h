// The time of impact of two balls with equal accelerations, from one quadratic.
#pragma once

#include <optional>

#include "fast/time_of_impact/first_contact.h"

namespace touchstone::fast::time_of_impact {

/// Whether both bodies are balls about their centres of mass and have equal accelerations.
bool are_falling_balls(const motion::BallisticMotion& a, const motion::BallisticMotion& b);

/// Relative to a, the centre of b moves along d + v h; they touch at |d + v h| = r_a + r_b = r. With the miss distance
/// x = |d − (d·v̂)v̂|,
///
///   h = (|d| − r)(|d| + r) / (−d·v + |v| sqrt(r² − x²))
///
/// (nearly equal numbers are subtracted only in d and r² − x²). Both ends of the enclosure are verified: at `lo` the
/// balls are separated by more than rounding and approach, so that they were separated before, since the distance along
/// a line is convex; at `hi` they overlap by more than rounding. No result if rounding prevents these decisions:
/// grazing balls, or balls that touch at `from` without separating. Requires are_falling_balls and that the two do not
/// overlap at `from`.
std::optional<FirstContact> spheres(const motion::BallisticMotion& a, const motion::BallisticMotion& b, double from,
                                    double until, double envelope);

}  // namespace touchstone::fast::time_of_impact
