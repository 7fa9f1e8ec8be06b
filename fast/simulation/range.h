// The numbers that a simulation in doubles supports, and the times at which positions are too coarse to continue.
#pragma once

#include "fast/simulation/prediction/body_motion.h"
#include "model/scene.h"

namespace touchstone::fast::simulation {

/// Throws BeyondDoubles, naming the first number whose square or product with others would over- or underflow. Lengths,
/// speeds and accelerations must be below 2^250 (about 1.8e75), sizes above 2^-250, and masses, moments of inertia and
/// energies within 2^±1000. Speeds may be arbitrarily small.
void refuse_beyond_doubles(const Scene& scene, const std::vector<BodyMotion>& bodies);

/// Whether the rounding of both positions (m; clearance(a, b, t, never), prediction/pair_time_of_impact.h) is less than
/// a thousandth of the smaller body. Otherwise doubles cannot decide whether the two touch, and the contact point of an
/// impact could be on neither.
bool positions_resolved(const BodyMotion& a, const BodyMotion& b, double rounding);

}  // namespace touchstone::fast::simulation
