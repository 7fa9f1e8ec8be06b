// The exact convex hull of double points, coplanar facets merged.
#pragma once

#include <vector>

#include "model/shape.h"

namespace touchstone::reference {

/// The hull's extreme vertices, in the order of the input, and its maximal plane faces, wound counter-clockwise seen from
/// outside, each starting at its least vertex, sorted. Exact: CGAL's convex_hull_3 on exact predicates, then coplanar
/// facets merged by exact orientation; collinear and interior points are dropped.
/// Throws InputError (place "points") if the points are fewer than 4 or all coplanar.
Polytope convex_hull(const std::vector<Vec3>& points);

}  // namespace touchstone::reference
