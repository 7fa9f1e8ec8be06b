// Decides whether 0 is on the boundary of B − A (the bodies touch) or inside (they overlap).
#pragma once

#include "fast/exact/nearest.h"

namespace touchstone::fast::exact {

/// Given pairs and weights with Σ weights·(b − a) = 0, decides between touching and overlapping and sets `normal` or
/// `around`.
///
/// The directions n with n·w ≥ 0 for all differences w found so far form a cone. A direction from its middle is
/// queried: a vertex with n·w < 0 cuts it off; without one, n is the normal of a supporting plane and the bodies touch.
/// When the cone is {0}, the differences found surround 0. Each vertex cuts off a direction that all previous ones had
/// left, so it is new; there are finitely many vertices, so this terminates.
void classify_contact(Difference& difference, Nearest& answer);

}  // namespace touchstone::fast::exact
