// A body's centre of mass, about which it rotates freely, with a bound on the error.
#pragma once

#include <optional>

#include "model/scene.h"

namespace touchstone::fast::outward {

struct CentreOfMass {
  Vec3 p_BBcm = Vec3::Zero();  ///< multiples of `unit`
  double error = 0;            ///< multiples of `unit`; ≥ |computed − exact| on each axis
  double least_mass = 0;       ///< kg; ≤ the exact mass, by at most 32u + (parts) u of it
};

/// Nothing for a fixed body. A polytope with a density: signed tetrahedra from the origin, summed without rounding, so
/// that thin and distant polytopes are as accurate as others. Throws InputError if a polytope's faces are missing or
/// its volume is not positive.
std::optional<CentreOfMass> centre_of_mass(const Body& body);

}  // namespace touchstone::fast::outward
