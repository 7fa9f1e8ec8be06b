// Scenes at the edge of what doubles can say: for the properties that ask only for an end, finite numbers and sense.
//
// No bound on rounding holds here: squares overflow, products vanish. So these families are not among families(); a run
// draws from them for the properties *.survives and *.repeats alone.
#pragma once

#include "properties/domain.h"

namespace touchstone::properties {

/// In a fixed order; drawn with `draw` like the others. All scenes are valid.
const std::vector<Family>& extremes();

}  // namespace touchstone::properties
