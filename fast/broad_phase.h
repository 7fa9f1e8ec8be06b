// The pairs of bodies whose boxes overlap, for a single query: the strategies of fast/broad_phase without their memory.
#pragma once

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::fast {

/// Up to this many bodies, testing each pair costs less than a grid (measured, docs/measured/plan.md: equal at 16
/// to 24).
inline constexpr std::size_t few_bodies = 16;

/// The pairs whose closed boxes (fast/bounds.h) share a point: every pair whose exact boxes do, and beyond those only
/// pairs whose exact boxes are apart by no more than the widening of the two boxes.
PairSet broad_phase(const Scene& scene);

/// Boxes that share only a boundary point overlap. Few boxes are tested pair by pair; more go through the default
/// strategy (fast/broad_phase/wrapped_grid.h), unless they have coordinates beyond its limit of 2^1000. Requires lo ≤
/// hi and no NaN.
PairSet overlapping_pairs(const Bounds& boxes);

}  // namespace touchstone::fast
