// The faces of a hull, for programs that do not link the reference's CGAL, because its licence would extend to them.
#pragma once

#include <vector>

#include "model/frame.h"

namespace touchstone::oracle {

/// Derives what reference::completed derives: the maximal plane faces of the vertices' hull, counter-clockwise seen
/// from outside, each from its least corner, sorted. Exact. Throws InputError under the same conditions: all vertices
/// lie in one plane, or one lies inside the hull. Requires at least 4 finite vertices without duplicates.
///
/// Gift wrapping (Chand and Kapur 1970): each edge of a known face leads to the plane on its other side. Cost:
/// O(vertices · faces).
std::vector<std::vector<int>> hull_faces(const std::vector<Vec3>& vertices);

}  // namespace touchstone::oracle
