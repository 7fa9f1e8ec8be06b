// Which bodies' boxes overlap: one sweep along an axis over sorted end points.
#pragma once

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::fast {

/// The pairs whose closed boxes (fast/bounds.h) share a point: every pair whose exact boxes do, and beyond those only
/// pairs whose boxes are apart by no more than the two boxes' widening.
PairSet broad_phase(const Scene& scene);

/// Boxes that share only a boundary point overlap. O(n log n + k), k pairs that overlap along x. Requires lo ≤ hi, no
/// NaN.
PairSet overlapping_pairs(const Bounds& boxes);

}  // namespace touchstone::fast
