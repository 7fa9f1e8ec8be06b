// Where flights have brought bodies, as doubles: the reference's enclosures, rounded. For judging, where a rounding of
// the pose is one of the roundings that are allowed (oracle/tolerance_motion.h).
#pragma once

#include <cstddef>

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::oracle {

/// The body's state after its flight from `since` (else 0) to `time`, each number rounded; at `since` itself the very
/// doubles. Requires what reference::flown requires.
State flown(const Scene& scene, std::size_t body, double time);

/// The scene with bodies 0 and 1 as flown, for questions about poses.
Scene pair_at(const Scene& scene, double time);

}  // namespace touchstone::oracle
