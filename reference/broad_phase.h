// Which closed tight boxes overlap: every pair is tested, O(n²), exactly.
#pragma once

#include "model/answers.h"
#include "model/scene.h"
#include "reference/bounds.h"

namespace touchstone::reference {

PairSet broad_phase(const Scene& scene);

/// The greatest gap between two boxes over the axes: > 0 exactly when they are apart, 0 when they touch.
Rational gap(const ExactBox& a, const ExactBox& b);

}  // namespace touchstone::reference
