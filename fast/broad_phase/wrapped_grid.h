// The default: every body in one cell only, cells wrapped onto a small table in the order of space. Keeps up at any
// size.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fast/broad_phase/strategy.h"

namespace touchstone::fast {

/// A body stands in the cell of its box's lo. Whom box a overlaps has its lo, on each axis, in [a.lo − reach, a.hi],
/// reach the greatest extent of any body on that axis: 2 to 4 rows of neighbouring cells. The cell is as wide as bodies
/// are apart on average (not as they are long), halved while cells are crowded; bodies longer than a cell go to a
/// coarser level, cells 4 times as long, and each body asks its own level and the coarser ones. Cells are wrapped like
/// a torus onto a table of about n/2 places, so that empty space costs nothing; neighbours in space stay neighbours in
/// memory, and a row of cells is one run of entries.
///
/// Coordinates are kept as floats in cells: f(x) = float((x − origin)/cell). f is monotone, so closed boxes that
/// overlap still do under f: nothing is missed, and the boxes in doubles decide every hit.
///
/// When more than a quarter of the bodies moved, the table is built anew by one counting sort. Otherwise only moved
/// bodies are treated: in place if they stay in their cell, else in a chain beside it, until a sixteenth stands in
/// chains.
///
/// Cost of a frame: O(moved + pairs + tests), n instead of moved when rebuilt. Worst case, all bodies in few cells:
/// O(n²).
class WrappedGrid final : public BroadPhase {
 private:
  /// Four lanes are compared at once, so the fourth must always overlap: 0 below, and above the id, which is less than
  /// 2^24 and so a float.
  struct alignas(16) Entry {
    std::array<float, 4> lo{};
    std::array<float, 4> hi{};

    BodyId body() const { return static_cast<BodyId>(hi[3]); }
    bool near(const Entry& e) const;
  };

  struct Level {
    float cells_per_unit = 1;  ///< 4^-level; a unit is a cell of level 0
    std::array<float, 3> reach{};
    std::array<std::int32_t, 3> mask{};  ///< cells along each axis before it wraps, less one
    std::array<int, 2> shift{};          ///< of y and z in a place's number
    std::uint32_t first_place = 0;
    std::uint32_t places = 0;
  };

  void refresh() override;

  void configure();
  double crowding();
  void lay_out_levels();
  bool fits(const Aabb& box) const;

  Entry entry_of(BodyId id) const;
  std::size_t level_of(const Entry& e) const;
  std::uint32_t place_of(const Entry& e, const Level& level) const;
  void widen(Level& level, const Entry& e);

  void rebuild();
  void find_all();
  bool must_rebuild() const;
  void treat_moved(BodyId id);
  void leave(BodyId id);
  void find_moved(BodyId id);

  /// Calls meet(entry) for each entry of the level that overlaps e, once, out of those whose lo.x ≥ least_x.
  template <bool with_chains, class Meet>
  void for_each_near(const Entry& e, float least_x, const Level& level, const Meet& meet) const;

  template <class Meet>
  void for_each_in(const Level& level, const Meet& meet) const;
  double rows(const Entry& e, const Level& level) const;

  Aabb domain_;  ///< where f is defined; bodies outside it make the grid anew
  double units_per_metre_ = 0;
  std::size_t configured_for_ = 0;
  int rebuilds_ = 0;
  std::vector<Level> levels_;

  std::vector<BodyId> ids_;
  std::vector<std::uint32_t> start_;  ///< by place, over all levels
  std::vector<Entry> entries_;        ///< in the order of places
  std::vector<std::uint32_t> slot_;   ///< by id: its entry
  std::vector<std::uint32_t> place_;  ///< by id
  std::vector<BodyId> chain_;         ///< by place: the first body that came after the last rebuild
  std::vector<BodyId> next_;          ///< by id
  std::size_t chained_ = 0;
};

}  // namespace touchstone::fast
