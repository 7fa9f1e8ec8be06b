// How far two bodies overlap along a direction.
#pragma once

#include "model/scene.h"
#include "oracle/truth/world_points.h"

namespace touchstone::properties {

/// m: the overlap of the convex bodies A and B along n, an upper bound on their depth. Negative: their gap along n.
oracle::Real overlap_along(const oracle::Point& n, const Body& A, const Body& B);

}  // namespace touchstone::properties
