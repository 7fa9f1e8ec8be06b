// A hierarchical hash grid (after Overmars) in which one box can be updated and queried at a time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fast/broad_phase/strategy.h"

namespace touchstone::fast::simulation {

/// Divides space into cells on several levels, where each level has cells twice as long as the one before. A box has
/// one entry: in the cell of its `lo`, on the first level whose cells are at least as long as the box. A query visits
/// every level that has boxes, in the cells that may contain the `lo` of an overlapping box. Cells are wrapped like a
/// torus onto a table, so that empty space costs nothing; a level with few boxes is scanned as a list.
///
/// Unlike in fast/broad_phase/hierarchical_hash.h, one box is updated in O(1) and queried in O(levels + boxes near it).
class HashGrid {
 public:
  /// `cell`: the cell length that suits most boxes. `bodies`: ids are below it.
  HashGrid(double cell, std::size_t bodies);

  void update_proxy(BodyId id, const Aabb& box);  ///< sets the body's box
  const Aabb& box(BodyId id) const { return proxies_[id].box; }

  /// The other bodies whose boxes overlap the body's box, in an unspecified order. Valid until the next call.
  std::span<const BodyId> neighbours(BodyId id);

 private:
  static constexpr std::uint32_t no_body = 0xffffffff;
  static constexpr int levels = 64;
  static constexpr int middle = 24;  ///< the level of the given cell length
  static constexpr std::size_t few = 12;
  static constexpr std::uint32_t room = 6;  ///< makes two cells fill a cache line

  /// One cache line: loading the box loads the rest, too.
  struct alignas(64) Proxy {
    Aabb box;
    std::int32_t level = -1;        ///< −1: not in the grid
    std::uint32_t cell = 0;         ///< in the level's table
    std::uint32_t at = 0;           ///< in the level's list
    std::uint32_t after = no_body;  ///< the next body in the overflow chain of the cell
  };
  struct alignas(32) Cell {
    BodyId bodies[room] = {};
    std::uint32_t count = 0;  ///< entries used
    BodyId more = no_body;
  };
  struct Level {
    double per_metre = 0;  ///< 1 / cell
    std::vector<BodyId> all;
    std::vector<Cell> cells;  ///< empty until the level has boxes
  };

  /// The index of the first of the consecutive cells of a row along x.
  std::uint32_t line(std::int64_t y, std::int64_t z) const {
    const std::int64_t mask = side_ - 1;
    return static_cast<std::uint32_t>(((z & mask) << shift_ | (y & mask)) << shift_);
  }
  void put(Cell& cell, BodyId id);
  void take(Cell& cell, BodyId id);
  void leave(Level& level, BodyId id);
  void enter(std::int32_t on, BodyId id);
  std::size_t collect(const Level& level, const Aabb& box, std::size_t size);

  std::int64_t side_ = 1;  ///< cells of a table along each axis: a power of two
  int shift_ = 0;          ///< side_ = 2^shift_
  std::vector<Proxy> proxies_;
  std::vector<Level> level_;
  std::vector<std::size_t> used_;  ///< levels that have or had boxes
  std::vector<BodyId> found_;      ///< the result and scratch space behind it: room for all bodies
};

}  // namespace touchstone::fast::simulation
