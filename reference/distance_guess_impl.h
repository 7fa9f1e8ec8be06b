// A guess at the vertex pairs that span the nearest point of A − B.
#pragma once

#include <utility>
#include <vector>

#include "reference/exact_pose_impl.h"

namespace touchstone::reference {

using VertexPair = std::pair<int, int>;  ///< of A, of B

/// At least 1 and at most 4 different pairs; possibly wrong. Call it outside RoundUpward.
std::vector<VertexPair> guess_nearest(const PosedPair& pair);

}  // namespace touchstone::reference
