// The time of impact of two bodies in ballistic motion.
#pragma once

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::fast {

/// For bodies 0 (A) and 1 (B) over the scene's motion. Requires a valid scene with a motion, whose polytopes have their
/// faces. Throws InputError if a motion is missing, or if the two bodies overlap at the start.
TimeOfImpact time_of_impact_of(const Scene& scene);

}  // namespace touchstone::fast
