// Clips a face by lines of the grid.
#pragma once

#include <vector>

#include "model/frame.h"

namespace touchstone::fast::pixel {

using Loop = std::vector<Vec3>;

/// The part of a convex loop with lo ≤ p[axis] ≤ hi (Sutherland & Hodgman 1974), computed so that no slope magnifies
/// rounding: a new corner is a point of an edge, whatever the error of its position along the edge.
///
/// Law: let each corner of the loop be within e of a point of a plane convex face, these points in order on its
/// boundary. If lo and hi are outside the true limits by e and the rounding of a cut, then the same holds for the
/// result (with e and that rounding) and a plane convex polygon that contains all of the face within the true limits.
void cut(const Loop& loop, int axis, double lo, double hi, Loop& scratch, Loop& result);

}  // namespace touchstone::fast::pixel
