#include "fast/broad_phase/cell_table.h"

#include <bit>
#include <cmath>

namespace touchstone::fast {
namespace {

/// Odd multipliers spread neighbouring cells; the last step mixes the high bits into the low ones.
std::size_t hash(const Cell& cell) {
  std::uint64_t h = static_cast<std::uint32_t>(cell.x) * 0x9e3779b97f4a7c15U;
  h = (h ^ static_cast<std::uint32_t>(cell.y)) * 0xbf58476d1ce4e5b9U;
  h = (h ^ static_cast<std::uint32_t>(cell.z)) * 0x94d049bb133111ebU;
  h = (h ^ static_cast<std::uint32_t>(cell.level)) * 0x9e3779b97f4a7c15U;
  return static_cast<std::size_t>(h >> 32U);
}

}  // namespace

Cell cell_of(const Vec3& p, int level, double size) {
  const auto index = [size](double x) { return static_cast<std::int32_t>(std::floor(x / size)); };
  return {level, index(p.x()), index(p.y()), index(p.z())};
}

void CellTable::group() {
  const std::size_t buckets = std::bit_ceil(entries_.size() + 1);
  start_.assign(buckets + 1, 0);
  for (const Entry& e : entries_) ++start_[hash(e.cell) & (buckets - 1)];
  std::uint32_t end = 0;
  for (std::uint32_t& start : start_) {
    end += start;
    start = end;
  }
  grouped_.resize(entries_.size());
  for (std::size_t i = entries_.size(); i > 0; --i) {
    const Entry& e = entries_[i - 1];
    grouped_[--start_[hash(e.cell) & (buckets - 1)]] = e;
  }
}

}  // namespace touchstone::fast
