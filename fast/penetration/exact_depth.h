// The exact penetration depth of the hulls of two posed point sets, for the pairs that doubles cannot decide.
#pragma once

#include "fast/exact/difference.h"
#include "model/answers.h"

namespace touchstone::fast::penetration {

struct ExactDepth {
  Interval depth;  ///< around the exact depth, relative width below 2^-46; m
  Vec3 n = Vec3::Zero();
};

/// Requires that 0 is inside B − A or on its boundary, and that B − A has interior points. The expanding-polytope
/// search with exact visibility, exact support points, and normals in the scale of the difference: it ends with facets
/// of B − A, and the nearest one. Heights are compared in doubles, with relative errors below 2^-49, so the interval
/// covers whichever of nearly equal ones is taken.
///
/// Terminates: each vertex pair is inserted at most once. Throws std::range_error if the depth is beyond doubles.
ExactDepth exact_depth(exact::Difference& difference);

}  // namespace touchstone::fast::penetration
