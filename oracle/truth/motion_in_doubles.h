// Positions and velocities after a ballistic motion, as doubles: the reference's enclosures, rounded. For judging,
// where one rounding of the pose is among the allowed roundings (oracle/tolerance/motion.h).
#pragma once

#include <cstddef>

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::oracle {

/// The body's state after ballistic motion from its start time (0 if none is given) to `time`, each number rounded; at
/// the start time itself exactly the scene's doubles. Requires what reference::ballistic_state requires.
State ballistic_state(const Scene& scene, std::size_t body, double time);

/// The scene with bodies 0 and 1 at `time`, for questions about poses.
Scene pair_at(const Scene& scene, double time);

}  // namespace touchstone::oracle
