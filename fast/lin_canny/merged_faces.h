// The maximal faces of a polytope whose given faces may have coplanar neighbours.
#pragma once

#include <vector>

#include "model/shape.h"

namespace touchstone::fast::lin_canny {

/// Loops of corners, counter-clockwise seen from outside, without straight corners, as indices of the polytope's
/// vertices. Coplanar and collinear are decided exactly. Throws InputError if an edge does not occur once in each
/// direction, or if the faces do not bound a convex solid.
std::vector<std::vector<int>> merged_faces(const Polytope& polytope);

}  // namespace touchstone::fast::lin_canny
