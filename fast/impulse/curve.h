// The part of an impact in which slip turns.
#pragma once

#include "fast/impulse/impact.h"
#include "fast/impulse/straight.h"

namespace touchstone::fast::impulse {

/// Slip turns by no more than rounding from here on.
bool is_straight(const Impact& impact, const Course& at);

/// Goes on until the goal, until slip stops, or until it turns no more (`straightened`).
///
/// Stretch by stretch (stretch.h), each as long as keeps its last two terms below 2^-56 of the whole; nothing is
/// singular at slip 0, and no u_n or W_n is divided by. A goal inside a stretch is a root of its polynomial; slip's
/// stop comes from a series of its own (stop.h). closest_miss: how near u_n came to the goal and turned back. Source:
/// docs/design/impulse.md.
enum class CurveEnd { goal, stop, straightened };
CurveEnd go_round(const Impact& impact, const Goal& goal, Course& at, double& closest_miss);

}  // namespace touchstone::fast::impulse
