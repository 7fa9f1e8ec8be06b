// When Newton's rule of restitution, by which steps rebound, may add energy.
#pragma once

#include "model/scene.h"

namespace touchstone::properties {

/// It may where friction acts out of line with the centre of mass: if a body that moves is no ball about its centre of
/// mass, and has with another one e > 0 and μ > 0.
bool restitution_may_add_energy(const Scene& scene);

}  // namespace touchstone::properties
