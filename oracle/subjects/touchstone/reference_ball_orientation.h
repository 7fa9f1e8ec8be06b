// How the ball of an exact motion turns, which is not part of the truth: it follows from the angular velocities.
#pragma once

#include <vector>

#include "model/scene.h"
#include "reference/constraint.h"

namespace touchstone::oracle::subjects {

/// The ball's orientation at each sample time. Between changes its angular velocity changes evenly.
///
/// Error: that of oracle::turn for each sample and change so far, and the rounding to doubles. While the angular
/// velocity changes, a ball that turns by more than 256 rad from one sample or change to the next is not followed: it
/// keeps the orientation that it had.
std::vector<Quaternion> orientations(const reference::ConstraintTruth& truth, const Scene& scene);

}  // namespace touchstone::oracle::subjects
