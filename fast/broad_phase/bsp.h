// Binary space partitioning by axis-parallel planes: leaves are regions with few bodies.
#pragma once

#include <vector>

#include "fast/broad_phase/strategy.h"

namespace touchstone::fast {

/// A region with more than 12 bodies is split at the median of their centres, along the axis on which these are spread
/// widest; a box that overlaps both sides goes to both. A split that would copy more than half of the bodies is not
/// made. A pair is reported by the leaf in which its overlap begins: regions are half open, so exactly one leaf reports
/// it.
///
/// Cost of a frame: O(n log n + copies); O(n²) if boxes are large compared with their distances. Rebuilt each frame.
class Bsp final : public BroadPhase {
 private:
  void refresh() override;

  /// Splits a region with the bodies from list_[first] to the end; leaves the list as it was.
  void split(std::size_t first, const Aabb& region);
  void report(std::size_t first, const Aabb& region);

  std::vector<BodyId> list_;  ///< a stack of the regions' bodies
  std::vector<double> centres_;
};

}  // namespace touchstone::fast
