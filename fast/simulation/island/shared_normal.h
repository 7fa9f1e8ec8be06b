// The normal of parts of a body that form one face together.
#pragma once

#include <span>

#include "fast/simulation/island/contact_pair.h"

namespace touchstone::fast::simulation {

/// Of all contact pairs of two bodies, just updated: lets pairs take over the normal of another one, and completes all.
///
/// A body that slides over parts of another, whose faces are in one plane, comes to the next part from its side. Taken
/// by itself that part is separated from it by its side too, and would stop it; but the side is inside the other body.
/// The face is not, so its normal is that of the next part as well. A pair takes the normal of another one that touches
/// if that separates its own parts, and its own normal does not separate those of the other pair. Of several pairs that
/// take over no normal themselves it takes that along which its parts are farthest apart.
///
/// Literature knows the wrong impact as that at an internal edge, or ghost collision.
void share_normals(std::span<ContactPair> pairs, const IslandBody& A, const IslandBody& B, double near);

}  // namespace touchstone::fast::simulation
