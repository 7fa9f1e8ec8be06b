// Binary space partitioning by axis-parallel planes: leaves are regions with few bodies.
#pragma once

#include <vector>

#include "fast/broad_phase/strategy.h"

namespace touchstone::fast {

/// A region with more than 12 bodies is cut at the median of their centres, along the axis on which these are spread
/// widest; a box that meets both sides goes to both. A cut that would copy more than half of the bodies is not made.
/// A pair is reported by the one leaf in which its overlap begins: regions are half open, so no leaf or two never own
/// it.
///
/// Cost of a frame: O(n log n + copies); O(n²) when boxes are large against their distances. Rebuilt each frame.
class Bsp final : public BroadPhase {
 private:
  void refresh() override;

  /// Bodies list_[first …] to the end; leaves the list as it found it.
  void split(std::size_t first, const Aabb& region);
  void report(std::size_t first, const Aabb& region);

  std::vector<BodyId> list_;  ///< a stack of regions' bodies
  std::vector<double> centres_;
};

}  // namespace touchstone::fast
