#include "reference/broad_phase.h"

#include <algorithm>

namespace touchstone::reference {
namespace {

bool overlap(const ExactBox& a, const ExactBox& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (a.hi[i] < b.lo[i] || b.hi[i] < a.lo[i]) return false;
  }
  return true;
}

}  // namespace

PairSet broad_phase(const Scene& scene) {
  const std::vector<ExactBox> boxes = bounds(scene);
  PairSet pairs;
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i) {
    for (int j = i + 1; j < static_cast<int>(boxes.size()); ++j) {
      if (overlap(boxes[i], boxes[j])) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

Rational gap(const ExactBox& a, const ExactBox& b) {
  Rational widest = std::max(b.lo[0] - a.hi[0], a.lo[0] - b.hi[0]);
  for (std::size_t i = 1; i < 3; ++i) widest = std::max({widest, b.lo[i] - a.hi[i], a.lo[i] - b.hi[i]});
  return widest;
}

}  // namespace touchstone::reference
