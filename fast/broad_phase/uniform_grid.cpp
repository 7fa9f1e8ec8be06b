#include "fast/broad_phase/uniform_grid.h"

#include <algorithm>
#include <cmath>

namespace touchstone::fast {
namespace {

// The cost of an entry in a cell's list relative to that of a box test, in the model that chooses the size of cells. A
// choice: an entry is written, sorted and read. The minimum of the model is flat.
constexpr double entry_per_test = 3;

// A choice that bounds memory where a few bodies are much larger than the others.
constexpr double entries_per_body = 16;

double cube(double x) { return x * x * x; }

double modelled_cost(double x, double density) {
  return entry_per_test * cube(1 + 1 / x) + 0.5 * density * cube((1 + x) * (1 + x) / x);
}

}  // namespace

void UniformGrid::refresh() {
  drop_ended();
  list_present(ids_);
  if (ids_.size() < 2) return;
  size_ = choose_cell_size();
  table_.clear();
  for (const BodyId id : ids_) {
    const Cell lo = cell_of(box_[id].lo, 0, size_);
    const Cell hi = cell_of(box_[id].hi, 0, size_);
    for (std::int32_t z = lo.z; z <= hi.z; ++z)
      for (std::int32_t y = lo.y; y <= hi.y; ++y)
        for (std::int32_t x = lo.x; x <= hi.x; ++x) table_.add({0, x, y, z}, id);
  }
  table_.group();
  for (std::size_t i = 0; i < table_.buckets(); ++i) report(table_.bucket(i));
}

void UniformGrid::report(std::span<const CellTable::Entry> bucket) {
  for (std::size_t i = 0; i < bucket.size(); ++i) {
    for (std::size_t j = i + 1; j < bucket.size(); ++j) {
      const Aabb& a = box_[bucket[i].body];
      const Aabb& b = box_[bucket[j].body];
      if (bucket[i].cell == bucket[j].cell && overlap(a, b) && cell_of(a.lo.cwiseMax(b.lo), 0, size_) == bucket[i].cell)
        offer(bucket[i].body, bucket[j].body);
    }
  }
}

double UniformGrid::choose_cell_size() const {
  Aabb all = box_[ids_.front()];
  Vec3 extents = Vec3::Zero();
  const double n = static_cast<double>(ids_.size());
  for (const BodyId id : ids_) {
    all.lo = all.lo.cwiseMin(box_[id].lo);
    all.hi = all.hi.cwiseMax(box_[id].hi);
    extents += (box_[id].hi - box_[id].lo) / n;
  }
  const double greatest = std::max(all.lo.lpNorm<Eigen::Infinity>(), all.hi.lpNorm<Eigen::Infinity>());
  const double mean = std::max(extents.mean(), 0x1p-1000);
  // Divided before it is multiplied: a volume in cubic metres may leave the range. A flat world counts as one body
  // thick.
  const Vec3 room = ((all.hi - all.lo) / mean).cwiseMax(1);
  const double density = n / room.x() / room.y() / room.z();
  double best = 1;
  for (double x = 1; x <= 64; x *= std::sqrt(2.0))
    if (modelled_cost(x, density) < modelled_cost(best, density)) best = x;
  // A cell's index has to fit 31 bits.
  double size = std::max(best * mean, greatest * 0x1p-30);
  while (entries_at(size) > entries_per_body * n) size *= 1.5;
  return size;
}

/// An upper bound of the number of entries: an extent of e overlaps at most ⌊e / size⌋ + 2 cells. Needs no cell
/// indices.
double UniformGrid::entries_at(double size) const {
  double entries = 0;
  for (const BodyId id : ids_) {
    const Vec3 cells = ((box_[id].hi - box_[id].lo) / size).array().floor() + 2;
    entries += cells.prod();
  }
  return entries;
}

}  // namespace touchstone::fast
