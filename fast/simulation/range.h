// Which numbers a simulation in doubles can compute with, and where places are too coarse to go on.
#pragma once

#include "fast/simulation/body.h"
#include "model/scene.h"

namespace touchstone::fast::world {

/// Throws BeyondDoubles naming the first number whose square or product with others would over- or underflow: lengths,
/// speeds and accelerations are below 2^250 (about 1.8e75), sizes above 2^-250, masses, moments of inertia and energies
/// within 2^±1000. (Slow is no trouble: speeds may be as small as they like.)
void refuse_beyond_doubles(const Scene& scene, const std::vector<Mover>& bodies);

/// Whether doubles tell at time t where the two are, to a thousandth of the smaller one: what rounding does to their
/// places (clearance, without its upper bound) is less than that. Else whether they meet is anybody's guess, and an
/// impact would be at a point that neither has.
bool places_tell(const Mover& a, const Mover& b, double t);

}  // namespace touchstone::fast::world
