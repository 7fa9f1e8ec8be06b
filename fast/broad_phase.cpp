#include "fast/broad_phase.h"

#include <algorithm>

#include "fast/bounds.h"
#include "fast/broad_phase/wrapped_grid.h"

namespace touchstone::fast {
namespace {

PairSet each_with_each(const Bounds& boxes) {
  PairSet pairs;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      if (overlap(boxes[i], boxes[j])) pairs.emplace_back(static_cast<int>(i), static_cast<int>(j));
    }
  }
  return pairs;
}

bool served(const Aabb& box) {
  return box.lo.cwiseAbs().maxCoeff() <= 0x1p1000 && box.hi.cwiseAbs().maxCoeff() <= 0x1p1000;
}

}  // namespace

PairSet overlapping_pairs(const Bounds& boxes) {
  if (boxes.size() <= few_bodies || !std::ranges::all_of(boxes, served)) return each_with_each(boxes);
  WrappedGrid grid;
  for (std::size_t i = 0; i < boxes.size(); ++i) grid.insert(static_cast<BodyId>(i), boxes[i]);
  grid.update();
  PairSet pairs;
  for (const auto& [a, b] : grid.pairs()) pairs.emplace_back(static_cast<int>(a), static_cast<int>(b));
  std::ranges::sort(pairs);
  return pairs;
}

PairSet broad_phase(const Scene& scene) { return overlapping_pairs(bounds(scene)); }

}  // namespace touchstone::fast
