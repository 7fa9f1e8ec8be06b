// A face cut by lines of the grid.
#pragma once

#include <vector>

#include "model/frame.h"

namespace touchstone::fast::pixels {

using Loop = std::vector<Vec3>;

/// What of a convex loop has lo ≤ p[axis] ≤ hi (Sutherland & Hodgman 1974), computed so that no slope magnifies
/// rounding: a new corner is a point of an edge, whatever its place along the edge is off by.
///
/// Law: let each corner of the loop be within e of a point of a plane convex face, these points in order on its
/// boundary. If lo and hi stand outside the true limits by e and the rounding of a cut, then the same holds of the
/// result (with e and that rounding) for a plane convex polygon that holds all of the face within the true limits.
void cut(const Loop& loop, int axis, double lo, double hi, Loop& scratch, Loop& result);

}  // namespace touchstone::fast::pixels
