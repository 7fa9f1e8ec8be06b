// The extreme points of the intersection of two convex polytopes.
#pragma once

#include "reference/half_space_impl.h"

namespace touchstone::reference {

/// Points of A ∩ B, all of its extreme points among them; none if A ∩ B is empty.
///
/// An extreme point of A ∩ B lies on an edge of A or of B: inside faces (or inside) of both it could move along both.
/// On an edge of A it is an end of what B leaves of that edge, else that could be lengthened through it. So each edge,
/// cut to what is in the other, gives its two ends.
std::vector<Triple> common_points(const Hull& A, const Hull& B);

}  // namespace touchstone::reference
