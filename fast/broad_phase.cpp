#include "fast/broad_phase.h"

#include <algorithm>
#include <numeric>

#include "fast/bounds.h"

namespace touchstone::fast {
namespace {

bool overlap_beyond_x(const Aabb& a, const Aabb& b) {
  return a.lo.y() <= b.hi.y() && b.lo.y() <= a.hi.y() && a.lo.z() <= b.hi.z() && b.lo.z() <= a.hi.z();
}

}  // namespace

PairSet overlapping_pairs(const Bounds& boxes) {
  std::vector<int> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  const auto box = [&](int i) -> const Aabb& { return boxes[static_cast<std::size_t>(i)]; };
  std::sort(order.begin(), order.end(), [&](int i, int j) { return box(i).lo.x() < box(j).lo.x(); });

  PairSet pairs;
  for (auto a = order.begin(); a != order.end(); ++a) {
    for (auto b = a + 1; b != order.end() && box(*b).lo.x() <= box(*a).hi.x(); ++b) {
      if (overlap_beyond_x(box(*a), box(*b))) pairs.emplace_back(std::minmax(*a, *b));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

PairSet broad_phase(const Scene& scene) { return overlapping_pairs(bounds(scene)); }

}  // namespace touchstone::fast
