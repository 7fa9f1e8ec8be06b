// Overmars' tiling as Mirtich uses it: a hash of cells on every scale, each body on its own and all coarser ones.
#pragma once

#include <cstdint>
#include <vector>

#include "fast/broad_phase/cell_table.h"
#include "fast/broad_phase/strategy.h"

namespace touchstone::fast {

/// Level l has cells of 2^l times the finest, a power of two ≥ the least extent. A body's native level is the first
/// whose cells are at least as great as its greatest extent, so that it meets at most 2 cells an axis there and above.
/// Two bodies are looked for on the coarser of their native levels, in the cell in which their overlap begins.
///
/// Law: at most 8 (1 + ⌈log₂ R⌉) entries a body, R the ratio of the greatest extent to the least (at most 2^30 counts).
/// Cost of a frame: O(n (1 + log R) + tests), if the density is bounded on every level. Rebuilt each frame.
class HierarchicalHash final : public BroadPhase {
 public:
  /// Entries made in the last update that searched.
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
