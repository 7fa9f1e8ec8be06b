// The plain uniform grid: space in equal cells, every box in all cells that it overlaps. The baseline of the default.
#pragma once

#include <vector>

#include "fast/broad_phase/cell_table.h"
#include "fast/broad_phase/strategy.h"

namespace touchstone::fast {

/// Two boxes that overlap share the cell in which their overlap begins (the cell of the greater of the two lo's). The
/// pair is tested in every shared cell and reported from that one.
///
/// Cell size. With s the mean extent, φ the density n s³/V and c = x s, a body occupies (1 + 1/x)³ cells and shares
/// them with ½ φ (1 + x)⁶/x³ others. With the cost of an entry to that of a test as 3 : 1, x minimises 3 (1 + 1/x)³ + ½
/// φ (1 + x)⁶/x³; then it grows until the entries are at most 16 n, so that no mixture of sizes can exhaust memory.
///
/// Cost of a frame: O(n + tests) if bodies have similar sizes; a great ratio of sizes makes it quadratic. Rebuilt each
/// frame.
class UniformGrid final : public BroadPhase {
 private:
  void refresh() override;
  double choose_cell_size() const;
  double entries_at(double size) const;
  void report(std::span<const CellTable::Entry> bucket);

  double size_ = 1;
  std::vector<BodyId> ids_;
  CellTable table_;
};

}  // namespace touchstone::fast
