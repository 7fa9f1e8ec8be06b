// When two balls under the same acceleration meet: one quadratic.
#pragma once

#include <optional>

#include "fast/time_of_impact.h"

namespace touchstone::fast::meeting {

/// Whether both bodies are balls about their centres of mass, and both fall alike.
bool are_falling_balls(const motion::Flight& a, const motion::Flight& b);

/// Seen from a the centre of b moves along d + v h: |d + v h| = r_a + r_b = r. With x = d − (d·v̂)v̂ the miss distance,
///
///   h = (|d| − r)(|d| + r) / (−d·v + |v| sqrt(r² − x²))
///
/// (no difference of like numbers but those in d and r² − x²). Both ends of the enclosure are proved by looking: at
/// `lo` the balls are apart, with more than rounding between, and approach — distance along a line is convex, so they
/// were apart before; at `hi` they surely overlap. None where rounding does not let that be seen: grazing balls, or
/// balls that touch at `from` without parting. Requires are_falling_balls and that the two do not overlap at `from`.
std::optional<Meeting> spheres(const motion::Flight& a, const motion::Flight& b, double from, double until,
                               double envelope);

}  // namespace touchstone::fast::meeting
