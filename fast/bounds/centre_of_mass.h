// Where a body's centre of mass is, and how sure that is: what turns freely turns about it.
#pragma once

#include <optional>

#include "model/scene.h"

namespace touchstone::fast::outward {

struct CentreOfMass {
  Vec3 p_BBcm = Vec3::Zero();  ///< multiples of `unit`
  double error = 0;            ///< ≥ |computed − exact| on each axis
  double least_mass = 0;       ///< kg; ≤ the exact one, by at most 32u + (parts) u of it
};

/// None for a fixed body. Polytopes of a density: signed tetrahedra from the origin, summed without rounding, so that
/// thin and far ones are no worse than others. Throws InputError where a polytope's faces are missing or its volume is
/// not positive.
std::optional<CentreOfMass> centre_of_mass(const Body& body);

}  // namespace touchstone::fast::outward
