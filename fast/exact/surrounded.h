// Where 0 is in B − A: on its boundary (the bodies touch), or inside (they overlap)?
#pragma once

#include "fast/exact/nearest.h"

namespace touchstone::fast::exact {

/// Given pairs and weights with Σ weights·(b − a) = 0, decides between touching and overlapping and fills in `normal`
/// or `around`.
///
/// The directions n with n·w ≥ 0 for all differences w found so far are a cone. A direction from its middle is asked: a
/// vertex with n·w < 0 cuts it off, else n is a supporting plane and the bodies touch. When the cone is {0}, what was
/// found surrounds 0. Each vertex cuts off a direction that all before it had left, so it is new: the vertices are
/// finite, and so is this.
void settle_contact(Difference& difference, Nearest& answer);

}  // namespace touchstone::fast::exact
