// The faces of a hull, for programs that do not link the reference's CGAL (whose licence would become theirs).
#pragma once

#include <vector>

#include "model/frame.h"

namespace touchstone::oracle {

/// What reference::completed derives: the maximal plane faces of the vertices' hull, counter-clockwise seen from
/// outside, each from its least corner, sorted. Exact. Throws InputError as it does: all in one plane, or one inside
/// the hull. Requires at least 4 finite vertices, each once.
///
/// Gift wrapping (Chand and Kapur 1970): each edge of a face that is known leads to the plane on its other side.
/// Cost: O(vertices · faces).
std::vector<std::vector<int>> hull_faces(const std::vector<Vec3>& vertices);

}  // namespace touchstone::oracle
