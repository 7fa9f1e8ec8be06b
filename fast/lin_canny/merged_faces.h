// The maximal faces of a polytope whose given faces may have coplanar neighbours.
#pragma once

#include <vector>

#include "model/shape.h"

namespace touchstone::fast::lin_canny {

/// Corner loops, counter-clockwise seen from outside, each corner a true one; by indices of the polytope's vertices.
/// Coplanar and collinear are decided exactly. Throws InputError where an edge is not met once in each direction, or
/// the faces do not bound a convex solid.
std::vector<std::vector<int>> merged_faces(const Polytope& polytope);

}  // namespace touchstone::fast::lin_canny
