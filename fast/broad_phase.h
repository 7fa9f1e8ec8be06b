// Which bodies' boxes overlap, asked once: the strategies of fast/broad_phase without their memory.
#pragma once

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::fast {

/// Up to here a grid costs more than each with each (measured, docs/design/broad_phase.md: they meet at 16 to 24).
inline constexpr std::size_t few_bodies = 16;

/// The pairs whose closed boxes (fast/bounds.h) share a point: every pair whose exact boxes do, and beyond those only
/// pairs whose boxes are apart by no more than the two boxes' widening.
PairSet broad_phase(const Scene& scene);

/// Boxes that share only a boundary point overlap. Few boxes are compared each with each; more go through the default
/// strategy (fast/broad_phase/wrapped_grid.h), but for those with coordinates beyond what it serves, 2^1000. Requires
/// lo ≤ hi, no NaN.
PairSet overlapping_pairs(const Bounds& boxes);

}  // namespace touchstone::fast
