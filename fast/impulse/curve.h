// The part of an impact in which the direction of slip changes.
#pragma once

#include "fast/impulse/impact.h"
#include "fast/impulse/straight.h"

namespace touchstone::fast::impulse {

/// Whether from here on slip changes its direction by no more than rounding.
bool is_straight(const Impact& impact, const ImpactState& at);

/// Continues until the goal, until slip stops, or until its direction is constant (`straightened`).
///
/// Proceeds in phases (phase.h), each so long that its last two terms stay below 2^-56 of the whole; nothing is
/// singular at slip 0, and nothing is divided by u_n or W_n. A goal inside a phase is a root of its polynomial; the end
/// of slip comes from a series of its own (stop.h). closest_miss: the least distance from the goal at which u_n turned
/// back. Source: docs/design/impulse.md.
enum class CurveEnd { goal, stop, straightened };
CurveEnd go_round(const Impact& impact, const Goal& goal, ImpactState& at, double& closest_miss);

}  // namespace touchstone::fast::impulse
