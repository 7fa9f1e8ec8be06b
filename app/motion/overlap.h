// Refuses scenes whose bodies overlap before anything has moved. No engine is asked about such a scene.
#pragma once

#include "model/scene.h"

namespace touchstone::app {

/// Throws InputError naming two bodies that overlap at the start, and the depth (m; for compounds, the depth of the two
/// parts that overlap most). Touching is allowed; rounding is tolerated between balls, between a ball and a fixed box
/// that does not turn, and for compounds. Fixed bodies may overlap each other.
///
/// Checks the pairs whose poses in the scene belong to one time: both bodies start at once, or the earlier one is fixed
/// at rest. Cost: a test of boxes (fast/broad_phase.h), then an exact query (reference/penetration.h) for each pair
/// whose boxes overlap.
///
/// Requires a completed scene.
void refuse_overlap(const Scene& scene);

}  // namespace touchstone::app
