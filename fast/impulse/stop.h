// The normal impulse that remains until slip stops, near the direction in which it stops.
#pragma once

#include <optional>

#include "fast/impulse/impact.h"

namespace touchstone::fast::impulse {

struct Stop {
  double impulse = 0;  ///< the remaining normal impulse (N s)
  double turn = 0;     ///< an upper bound of the angle to the direction in which slip stops
};

/// Nothing if slip does not stop from here, or is too far from its last direction for the series (|tan(δ/2)| > 1/2).
///
/// With θ the direction, s dθ/dp = η(θ) and ds/dp = g(θ). The remaining impulse is s Φ(θ) with η Φ' + g Φ = −1. At a
/// root θ* of η with η' < 0 and g < 0, Φ is a power series in t = tan((θ − θ*)/2): its recurrence divides by n η'(θ*) +
/// g(θ*) < 0. Summed until terms are below 2^-58 of the sum. Source: docs/design/impulse.md.
std::optional<Stop> until_stop(const Impact& impact, const ImpactState& at);

}  // namespace touchstone::fast::impulse
