// Do solids share space before anything has moved? That is no scene to follow, whoever follows it.
#pragma once

#include "model/scene.h"

namespace touchstone::app {

/// Throws InputError naming two bodies that overlap as they set out, and the depth (m; of compounds that of
/// the two parts that overlap most). Touching is fine, within rounding between balls, between a ball and a fixed
/// box that does not turn, and of compounds; and fixed bodies may overlap each other.
///
/// Pairs are asked whose poses stand in the scene: both set out at once, or who sets out first stands still. Cost:
/// boxes first (fast/broad_phase.h), then an exact question (reference/penetration.h) a pair whose boxes meet.
///
/// Requires a completed scene.
void refuse_overlap(const Scene& scene);

}  // namespace touchstone::app
