// A box as a polytope.
#pragma once

#include <vector>

#include "model/shape.h"

namespace touchstone {

/// The eight vertices in the order of Box, in its frame (m), without rounding.
std::vector<Vec3> vertices_of(const Box& box);

/// The same points, with the six faces counter-clockwise seen from outside.
Polytope as_polytope(const Box& box);

}  // namespace touchstone
