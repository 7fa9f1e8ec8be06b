#include "fast/lin_canny/nearest_parts.h"

#include <algorithm>
#include <utility>

#include "model/infinity.h"

namespace touchstone::fast::lin_canny {
namespace {

bool is_nearer(const Proximity& x, const Proximity& y) {
  return x.verdict != y.verdict ? x.verdict > y.verdict : x.distance < y.distance;
}

/// The distance of the bodies' origins minus the parts' reach from there, rounded down: 8u covers the norm and the
/// sums.
bool is_surely_farther(double origins_apart, const Convex& A, const Convex& B, double than) {
  return origins_apart * (1 - 8 * u) - (A.reach + B.reach) * (1 + 8 * u) > than;
}

/// `measure(i, j)`: the proximity of part i of A and part j of B.
template <class Measure>
NearestParts nearest_of_all(const Solid& A, const CachedPose& at_A, const Solid& B, const CachedPose& at_B,
                            Measure&& measure) {
  const double origins_apart = (at_B.X_WB.p_WB - at_A.X_WB.p_WB).stableNorm();
  NearestParts nearest;
  Interval enclosure{infinity, infinity};
  for (std::size_t i = 0; i < A.parts().size(); ++i) {
    for (std::size_t j = 0; j < B.parts().size(); ++j) {
      if (is_surely_farther(origins_apart, A.parts()[i], B.parts()[j], enclosure.hi)) continue;
      Proximity found = measure(i, j);
      const bool is_first = enclosure.hi == infinity;
      enclosure = {std::min(enclosure.lo, found.enclosure.lo), std::min(enclosure.hi, found.enclosure.hi)};
      if (!is_first && !is_nearer(found, nearest.proximity)) continue;
      nearest = {std::move(found), static_cast<int>(i), static_cast<int>(j)};
    }
  }
  nearest.proximity.enclosure = enclosure;
  return nearest;
}

}  // namespace

NearestParts nearest_parts(const Solid& A, const CachedPose& at_A, const Solid& B, const CachedPose& at_B,
                           std::span<FeaturePair> memory) {
  return nearest_of_all(A, at_A, B, at_B, [&](std::size_t i, std::size_t j) {
    return proximity(A.parts()[i], at_A, B.parts()[j], at_B, memory[i * B.parts().size() + j]);
  });
}

NearestParts nearest_parts(const Solid& A, const CachedPose& at_A, const Solid& B, const CachedPose& at_B) {
  return nearest_of_all(A, at_A, B, at_B, [&](std::size_t i, std::size_t j) {
    return proximity(A.parts()[i], at_A, B.parts()[j], at_B);
  });
}

}  // namespace touchstone::fast::lin_canny
