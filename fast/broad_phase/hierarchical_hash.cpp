#include "fast/broad_phase/hierarchical_hash.h"

#include <algorithm>
#include <cmath>

#include "model/infinity.h"

namespace touchstone::fast {
namespace {

/// The greatest extent, rounded up: then a box is exactly no longer than a cell of at least that computed size.
double extent(const Aabb& box) {
  const double rounded = (box.hi - box.lo).maxCoeff();
  return rounded == 0 ? 0 : std::nextafter(rounded, infinity);
}

double power_of_two_from(double x) {
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  return std::ldexp(1, mantissa == 0.5 ? exponent - 1 : exponent);
}

}  // namespace

/// Powers of two, so that p / size is exact and a box no longer than a cell overlaps at most two of them.
double HierarchicalHash::size(int level) const { return std::ldexp(finest_, level); }

void HierarchicalHash::refresh() {
  drop_ended();
  list_present(ids_);
  table_.clear();
  if (ids_.size() < 2) return;
  choose_levels();
  native_.resize(box_.size());
  for (const BodyId id : ids_) enter(id);
  table_.group();
  for (std::size_t i = 0; i < table_.buckets(); ++i) report(table_.bucket(i));
}

void HierarchicalHash::choose_levels() {
  double least = infinity;
  double greatest = 0;
  double farthest = 0;
  for (const BodyId id : ids_) {
    least = std::min(least, extent(box_[id]));
    greatest = std::max(greatest, extent(box_[id]));
    farthest = std::max({farthest, box_[id].lo.lpNorm<Eigen::Infinity>(), box_[id].hi.lpNorm<Eigen::Infinity>()});
  }
  // A cell's index has to fit 31 bits, and cells finer than 2^-30 of the greatest body only add levels.
  finest_ = power_of_two_from(std::max({least, farthest * 0x1p-30, greatest * 0x1p-30, 0x1p-1000}));
  levels_ = 1;
  while (size(levels_ - 1) < greatest) ++levels_;
}

void HierarchicalHash::enter(BodyId id) {
  const Aabb& box = box_[id];
  int level = 0;
  while (size(level) < extent(box)) ++level;
  native_[id] = static_cast<std::uint8_t>(level);
  for (; level < levels_; ++level) {
    const Cell lo = cell_of(box.lo, level, size(level));
    const Cell hi = cell_of(box.hi, level, size(level));
    for (std::int32_t z = lo.z; z <= hi.z; ++z)
      for (std::int32_t y = lo.y; y <= hi.y; ++y)
        for (std::int32_t x = lo.x; x <= hi.x; ++x) table_.add({level, x, y, z}, id);
  }
}

void HierarchicalHash::report(std::span<const CellTable::Entry> bucket) {
  for (std::size_t i = 0; i < bucket.size(); ++i) {
    const Cell& cell = bucket[i].cell;
    const BodyId a = bucket[i].body;
    for (std::size_t j = i + 1; j < bucket.size(); ++j) {
      const BodyId b = bucket[j].body;
      const bool coarser_native_level = std::max(native_[a], native_[b]) == cell.level;
      if (coarser_native_level && bucket[j].cell == cell && overlap(box_[a], box_[b]) &&
          cell_of(box_[a].lo.cwiseMax(box_[b].lo), cell.level, size(cell.level)) == cell)
        offer(a, b);
    }
  }
}

}  // namespace touchstone::fast
