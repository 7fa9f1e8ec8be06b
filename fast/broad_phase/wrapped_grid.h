// The default strategy: fat boxes in cells, and lists of the near pairs. A body that moves a little needs no grid
// query.
#pragma once

#include <cstdint>
#include <vector>

#include "fast/broad_phase/strategy.h"
#include "fast/broad_phase/wrapped_cells.h"

namespace touchstone::fast {

/// A body's box is kept in the grid with a margin: 8 times its motion in the last frame. The pairs whose fat boxes
/// overlap are kept in two lists: those whose boxes overlap (pairs()) and those that are merely near. While every box
/// stays within its fat box, a frame scans the two lists, and pairs move between them as they begin and end. A body
/// that left its fat box gets a new one and its near pairs are searched; if an eighth of the bodies left, the grid is
/// rebuilt by one counting sort.
///
/// The grid: a body is entered in the cell of its fat box's lo. A fat box that overlaps fat box a has its lo, on each
/// axis, in [a.lo − reach, a.hi], with reach the greatest extent of any fat box on that axis: 2 to 4 rows of
/// neighbouring cells. Cells are as wide as the average distance of bodies (not as their extent), halved while cells
/// are crowded; bodies longer than a cell go to a coarser level, with cells 4 times as long, and each body queries its
/// own level and the coarser ones. Cells are wrapped like a torus onto a table of about n/2 places, so that empty space
/// costs nothing; neighbours in space stay neighbours in memory, and a row of cells is one run of entries. Bodies that
/// changed their cell since the last sort are in chains beside it.
///
/// The grid works with floats (wrapped_cells.h says why no pair is missed); the boxes in doubles decide every pair.
///
/// Cost of a frame: O(moved + pairs + near pairs) while margins hold; every 8th frame or so O(n + tests). Worst case,
/// all bodies in few cells: O(n²).
class WrappedGrid final : public BroadPhase {
 private:
  /// The entries of bodies that changed their cell since the last sort, as a list for each place.
  struct Chains {
    std::vector<std::uint32_t> last;   ///< by place: slot of the entry that was chained last
    std::vector<std::uint32_t> links;  ///< the slot chained before, by slot from first_slot on
    std::size_t first_slot = 0;        ///< the number of entries in the order of places

    std::uint32_t& before(std::uint32_t slot) { return links[slot - first_slot]; }
    std::uint32_t before(std::uint32_t slot) const { return links[slot - first_slot]; }
  };

  void refresh() override;

  void list_escaped();
  bool many_escaped() const { return 8 * escaped_.size() > count(); }
  bool must_rebuild() const;

  void rebuild();
  void sort_into_cells();
  void find_all();
  void separate_overlapping();
  void prefetch_boxes(std::size_t i) const;
  void scan_pairs();
  void scan_near();
  void update_entry(BodyId id);
  void leave(BodyId id);
  void find_escaped(BodyId id);

  /// Calls visit(entry) once for each entry of the level that overlaps e, among those with lo.x ≥ least_x.
  template <bool with_chains, class Visit>
  void for_each_near(const CellBox& e, float least_x, const CellLevel& level, const Visit& visit) const;

  template <class Visit>
  void for_each_in(const CellLevel& level, const Visit& visit) const;

  WrappedCells cells_;
  std::size_t laid_out_for_ = 0;
  int sorts_ = 0;  ///< since the cells were laid out

  std::vector<BodyPair> near_;         ///< fat boxes overlap, boxes do not
  std::vector<BodyId> escaped_;        ///< ids whose fat box must be made again, or that were removed
  std::vector<std::uint8_t> escapes_;  ///< by id: whether it is in escaped_

  std::vector<BodyId> ids_;
  std::vector<std::uint32_t> start_;  ///< by place, over all levels
  std::vector<CellBox> entries_;      ///< in the order of places; then those in chains
  std::vector<std::uint32_t> slot_;   ///< by id: its entry
  Chains chains_;
};

}  // namespace touchstone::fast
