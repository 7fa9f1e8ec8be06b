// The exact route to a pair's proximity.
#pragma once

#include "fast/lin_canny/proximity.h"

namespace touchstone::fast::lin_canny {

/// `guess` names features whose vertices may be closest; a bad guess costs time alone.
Proximity settle(const Convex& A, const Station& body_A, const Convex& B, const Station& body_B,
                 const FeaturePair& guess);

}  // namespace touchstone::fast::lin_canny
