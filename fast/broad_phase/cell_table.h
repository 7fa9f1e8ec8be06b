// Bodies by the cells of space that they overlap: a list of entries, sorted by the hash of their cell.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "fast/broad_phase/strategy.h"

namespace touchstone::fast {

/// A cubic cell of the grid of `level`, with indices counted from the origin.
struct Cell {
  std::int32_t level = 0;
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t z = 0;

  bool operator==(const Cell&) const = default;
};

/// floor(p / size), for |p / size| < 2^31. A cast would merge the cells on both sides of 0.
Cell cell_of(const Vec3& p, int level, double size);

class CellTable {
 public:
  struct Entry {
    Cell cell;
    BodyId body = 0;
  };

  void clear() { entries_.clear(); }
  void add(const Cell& cell, BodyId body) { entries_.push_back({cell, body}); }
  std::size_t entries() const { return entries_.size(); }

  /// Sorts the entries by bucket (one counting sort). The entries of a cell are then in one bucket, in the order added.
  void group();
  std::size_t buckets() const { return start_.size() - 1; }
  std::span<const Entry> bucket(std::size_t i) const {
    return {grouped_.data() + start_[i], start_[i + 1] - start_[i]};
  }

 private:
  std::vector<Entry> entries_;
  std::vector<Entry> grouped_;
  std::vector<std::uint32_t> start_ = {0};
};

}  // namespace touchstone::fast
