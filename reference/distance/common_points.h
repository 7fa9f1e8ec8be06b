// The extreme points of the intersection of two convex polytopes.
#pragma once

#include "reference/hull/half_space.h"

namespace touchstone::reference {

/// Returns points of A ∩ B that include all its extreme points; empty if A ∩ B is empty.
///
/// An extreme point of A ∩ B lies on an edge of A or of B: inside faces of both, or in the interior, it could move
/// within both. On an edge of A it is an end of the part of the edge inside B, else that part could be extended beyond
/// it. So each edge, clipped to the other polytope, gives its two ends.
std::vector<Triple> common_points(const Hull& A, const Hull& B);

}  // namespace touchstone::reference
