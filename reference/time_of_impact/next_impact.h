// The next impact of a pair in ballistic motion.
#pragma once

#include <cstddef>
#include <stdexcept>

#include "model/infinity.h"
#include "model/scene.h"
#include "reference/time_of_impact.h"

namespace touchstone::reference {

/// Thrown where the trajectory of a tumbling body is unknown (reference/ballistic_motion.h).
struct MotionUnknown : std::runtime_error {
  MotionUnknown() : std::runtime_error("a tumbling body is not known any more") {}
};

/// The body at a time of its motion, about to the nearest doubles. Throws MotionUnknown.
Body moved(const Scene& scene, std::size_t body, double time);

struct NextImpact {
  bool known = true;           ///< false: nothing is known of the pair after `time`
  double time = infinity;      ///< s; infinite: no impact in this motion
  bool micro_bounces = false;  ///< starts within the envelope and has not been seen to leave it before `time`
};

/// The pair is within half the envelope and approaches. At all times before, it is proved to be at least that far
/// apart, or not approaching. Two bodies that start nearer than that (usually after an impact) and separate may leave
/// the envelope and come back, or come nearer still: by a 64th of their gap. Requires two bodies with a motion. Throws
/// MotionUnknown.
NextImpact next_impact(const Scene& pair, double envelope);

}  // namespace touchstone::reference
