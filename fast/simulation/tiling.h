// Overmars' tiling, kept up box by box: who is near this box, asked after every impact.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fast/broad_phase/strategy.h"

namespace touchstone::fast::world {

/// Space in cells on several scales, each twice as long as the one before. A box is filed once, in the cell of its lo,
/// on the first level whose cells are at least as long as the box; a question looks on every level that has boxes, in
/// the cells where the lo of a box that it meets may stand. Cells are wrapped like a torus onto a table, so that empty
/// space costs nothing; a level with few boxes is looked through as a list.
///
/// Unlike fast/broad_phase/hierarchical_hash.h one box changes in O(1), and is asked about in O(levels + boxes near).
class Tiling {
 public:
  /// `cell`: the length for which most boxes are meant. `bodies`: ids are below it.
  Tiling(double cell, std::size_t bodies);

  void file(BodyId id, const Aabb& box);  ///< where it stands from now on
  const Aabb& box(BodyId id) const { return filed_[id].box; }

  /// Whom the body's box overlaps, without itself; in no order that means anything. Valid until it is asked again.
  std::span<const BodyId> near(BodyId id);

 private:
  static constexpr std::uint32_t nobody = 0xffffffff;
  static constexpr int levels = 64;
  static constexpr int middle = 24;  ///< the level of the given cell
  static constexpr std::size_t few = 12;
  static constexpr std::uint32_t room = 6;  ///< so that two cells are a line of memory

  /// A line of memory: who asks for a box has the rest, too.
  struct alignas(64) Filed {
    Aabb box;
    std::int32_t level = -1;       ///< −1: not filed
    std::uint32_t cell = 0;        ///< in the level's table
    std::uint32_t at = 0;          ///< in the level's list
    std::uint32_t after = nobody;  ///< in the chain of those for whom the cell has no room
  };
  struct alignas(32) Cell {
    BodyId bodies[room] = {};
    std::uint32_t count = 0;  ///< of these
    BodyId more = nobody;
  };
  struct Level {
    double per_metre = 0;  ///< 1 / cell
    std::vector<BodyId> all;
    std::vector<Cell> cells;  ///< none until the level has boxes
  };

  /// The cells of a line along x stand side by side from here on.
  std::uint32_t line(std::int64_t y, std::int64_t z) const {
    const std::int64_t mask = side_ - 1;
    return static_cast<std::uint32_t>(((z & mask) << shift_ | (y & mask)) << shift_);
  }
  void put(Cell& cell, BodyId id);
  void take(Cell& cell, BodyId id);
  void leave(Level& level, BodyId id);
  void enter(std::int32_t on, BodyId id);
  std::size_t look(const Level& level, const Aabb& box, std::size_t size);

  std::int64_t side_ = 1;  ///< cells of a table along each axis: a power of two
  int shift_ = 0;          ///< side_ = 2^shift_
  std::vector<Filed> filed_;
  std::vector<Level> level_;
  std::vector<std::size_t> used_;  ///< levels that have or had boxes
  std::vector<BodyId> found_;      ///< what is asked for, and beyond it what was: room for all
};

}  // namespace touchstone::fast::world
