// What applied forces give to bodies until a time.
#pragma once

#include <vector>

#include "model/scene.h"

namespace touchstone::properties {

struct AppliedImpulse {
  Vec3 total = Vec3::Zero();      ///< N s, of all bodies: ∫ F dt
  std::vector<double> of_bodies;  ///< N s, indexed by body: ∫ |F| dt
  double changes = 0;             ///< N: Σ |ΔF| over the times at which a force begins, changes or ends
};

/// From the start of the motion, where all bodies start at time 0, until `time` (s).
AppliedImpulse applied_until(const Scene& scene, double time);

}  // namespace touchstone::properties
