// Which closed tight boxes overlap: tests every pair exactly, in O(n²).
#pragma once

#include <optional>
#include <vector>

#include "model/answers.h"
#include "model/scene.h"
#include "reference/bounds.h"

namespace touchstone::reference {

/// The pairs whose closed exact boxes (reference/bounds.h) share a point, at the bodies' poses X_WB. Requires a valid
/// scene; faces are not needed.
PairSet broad_phase(const Scene& scene);

/// The boxes by body; none for a body that is not in the frame.
using FrameBoxes = std::vector<std::optional<ExactBox>>;

/// The boxes after each frame. Requires that each placement names a body of the scene.
std::vector<FrameBoxes> sequence_bounds(const Scene& sequence);

/// Tests every pair in every frame. `begun` and `ended` are the differences between the sets of successive frames.
PairHistory pair_history(const std::vector<FrameBoxes>& frames);

/// The greatest gap between two boxes over the three axes (m): > 0 exactly if they are apart, 0 if they touch.
Rational gap(const ExactBox& a, const ExactBox& b);

}  // namespace touchstone::reference
