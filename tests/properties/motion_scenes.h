// Flights and runs by hand: a few of each kind, for the properties about motion.
#pragma once

#include <vector>

#include "model/scene.h"

namespace touchstone::tests {

/// For time_of_impact: two bodies.
const std::vector<Scene>& flights();

/// For simulation: each over within a few impacts.
const std::vector<Scene>& runs();

}  // namespace touchstone::tests
