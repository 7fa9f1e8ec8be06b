// The exact route to a pair's proximity.
#pragma once

#include <vector>

#include "fast/exact/difference.h"
#include "fast/lin_canny/proximity.h"

namespace touchstone::fast::lin_canny {

/// `guess` names features whose vertices may be closest; a bad guess only costs time.
Proximity exact_proximity(const Convex& A, const CachedPose& body_A, const Convex& B, const CachedPose& body_B,
                          const FeaturePair& guess);

/// `guess`: at least one pair of vertices of the cores.
Proximity exact_proximity(const Convex& A, const CachedPose& body_A, const Convex& B, const CachedPose& body_B,
                          const std::vector<exact::VertexPair>& guess);

}  // namespace touchstone::fast::lin_canny
