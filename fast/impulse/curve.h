// The part of an impact in which slip turns: Taylor series in regularised time.
#pragma once

#include "fast/impulse/impact.h"
#include "fast/impulse/straight.h"

namespace touchstone::fast::impulse {

/// Slip turns by no more than rounding from here on.
bool is_straight(const Impact& impact, const Course& at);

/// Goes on until the goal, until slip stops, or until it turns no more (`straightened`).
///
/// With dτ = dp/s: (c, d)' = η (−d, c), s' = g s, P_t' = −mu s (c, d), p' = s, where η and g are polynomials in c and
/// d. Nothing is singular at s → 0, and no u_n or W_n is divided by. Each step sums 20 terms, and is as long as keeps
/// the last two below 2^-56. A goal inside a step is a root of its polynomial. Source: docs/design/impulse.md.
enum class CurveEnd { goal, stop, straightened };
CurveEnd go_round(const Impact& impact, const Goal& goal, Course& at, double& closest_miss);

}  // namespace touchstone::fast::impulse
