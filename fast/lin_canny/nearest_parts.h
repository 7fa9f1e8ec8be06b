// How far apart two bodies are that may be unions of convex parts.
#pragma once

#include <span>

#include "fast/lin_canny/proximity.h"

namespace touchstone::fast::lin_canny {

struct NearestParts {
  Proximity proximity;  ///< of the nearest two parts; the enclosure is that of the bodies' distance
  int part_A = 0;
  int part_B = 0;
};

/// The least over the pairs of parts: overlap is nearer than touching, touching nearer than any distance; ties in the
/// parts' order. Parts whose bounding balls are farther apart than what was found are passed over.
///
/// `memory[i · parts of B + j]` is the walk's place between part i of A and part j of B; it starts as {} and is kept by
/// the caller for as long as the two bodies are followed.
NearestParts nearest_parts(const Solid& A, const Station& at_A, const Solid& B, const Station& at_B,
                           std::span<FeaturePair> memory);

}  // namespace touchstone::fast::lin_canny
