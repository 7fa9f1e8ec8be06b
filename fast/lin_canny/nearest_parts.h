// The distance of two bodies that may be unions of convex parts.
#pragma once

#include <cstddef>
#include <span>

#include "fast/lin_canny/proximity.h"

namespace touchstone::fast::lin_canny {

struct NearestParts {
  Proximity proximity;  ///< of the nearest two parts; its enclosure is that of the bodies' distance
  int part_A = 0;
  int part_B = 0;
};

/// How many entries of memory two bodies need: one for each pair of parts.
inline std::size_t pairs_of_parts(const Solid& A, const Solid& B) { return A.parts().size() * B.parts().size(); }

/// The minimum over the pairs of parts: overlapping is nearer than touching, touching nearer than any distance; ties
/// are resolved in the order of parts. Pairs whose bounding balls are farther apart than the minimum so far are
/// skipped.
///
/// `memory[i · parts of B + j]` is where the walk between part i of A and part j of B ended; it starts as {} and is
/// kept by the caller while it follows the two bodies.
NearestParts nearest_parts(const Solid& A, const CachedPose& at_A, const Solid& B, const CachedPose& at_B,
                           std::span<FeaturePair> memory);

/// From the vertices alone, for bodies that are asked about once (Solid::Preparation::vertices will do).
NearestParts nearest_parts(const Solid& A, const CachedPose& at_A, const Solid& B, const CachedPose& at_B);

}  // namespace touchstone::fast::lin_canny
