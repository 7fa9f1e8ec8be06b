// Overmars' tiling as Mirtich uses it: a hash of cells on every scale; each body is entered on its own and all coarser
// ones.
#pragma once

#include <cstdint>
#include <vector>

#include "fast/broad_phase/cell_table.h"
#include "fast/broad_phase/strategy.h"

namespace touchstone::fast {

/// Level l has cells of 2^l times the finest size, which is a power of two ≥ the least extent. A body's native level is
/// the first whose cells are at least as large as its greatest extent, so that it overlaps at most 2 cells per axis
/// there and above. A pair is searched on the coarser of its native levels, in the cell in which its overlap begins.
///
/// Law: at most 8 (1 + ⌈log₂ R⌉) entries per body, R the ratio of the greatest extent to the least (at most 2^30
/// counts). Cost of a frame: O(n (1 + log R) + tests), if the density is bounded on every level. Rebuilt each frame.
class HierarchicalHash final : public BroadPhase {
 public:
  /// Number of entries made in the last update that searched.
  std::size_t entries() const { return table_.entries(); }

 private:
  void refresh() override;
  void choose_levels();
  void enter(BodyId id);
  void report(std::span<const CellTable::Entry> bucket);
  double size(int level) const;

  double finest_ = 1;
  int levels_ = 1;
  std::vector<std::uint8_t> native_;  ///< by id
  std::vector<BodyId> ids_;
  CellTable table_;
};

}  // namespace touchstone::fast
