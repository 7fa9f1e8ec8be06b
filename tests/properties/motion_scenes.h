// Motions made by hand, a few of each kind, for the properties about motion.
#pragma once

#include <vector>

#include "model/scene.h"

namespace touchstone::tests {

/// For time_of_impact: scenes of two bodies.
const std::vector<Scene>& motion_scenes();

/// For simulation: scenes that end after a few impacts.
const std::vector<Scene>& runs();

}  // namespace touchstone::tests
