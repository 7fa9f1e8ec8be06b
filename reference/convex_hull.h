// The exact convex hull of points in doubles, with coplanar facets merged.
#pragma once

#include <vector>

#include "model/shape.h"

namespace touchstone::reference {

/// Returns the extreme vertices in the order of the input, and the maximal plane faces, sorted. Each face is wound
/// counter-clockwise seen from outside and starts at its least vertex. Exact: CGAL's convex_hull_3 on exact predicates,
/// then coplanar facets are merged by exact orientation; collinear and interior points are dropped.
/// Throws InputError (place "points") if there are fewer than 4 points or all are coplanar.
Polytope convex_hull(const std::vector<Vec3>& points);

}  // namespace touchstone::reference
