// Which closed tight boxes overlap: every pair is tested, O(n²), exactly.
#pragma once

#include <optional>
#include <vector>

#include "model/answers.h"
#include "model/scene.h"
#include "reference/bounds.h"

namespace touchstone::reference {

PairSet broad_phase(const Scene& scene);

/// By body; none: it is not there.
using FrameBoxes = std::vector<std::optional<ExactBox>>;

/// The boxes after each frame.
std::vector<FrameBoxes> film_bounds(const Scene& film);

/// Every pair in every frame: begun and ended are the differences of one frame's set to the next.
PairHistory pair_history(const std::vector<FrameBoxes>& frames);

/// The greatest gap between two boxes over the axes: > 0 exactly when they are apart, 0 when they touch.
Rational gap(const ExactBox& a, const ExactBox& b);

}  // namespace touchstone::reference
