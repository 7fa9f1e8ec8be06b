// Scenes at the limits of doubles, for the properties that only require termination, finite numbers and a consistent
// answer.
//
// No bound on rounding holds here: squares overflow, products underflow. Therefore these families are not among
// families(); a run draws from them only for the properties *.survives and *.repeats.
#pragma once

#include "properties/scenes/domain.h"

namespace touchstone::properties {

/// In a fixed order; `draw` applies to them as to other families. All scenes are valid.
const std::vector<Family>& extremes();

}  // namespace touchstone::properties
