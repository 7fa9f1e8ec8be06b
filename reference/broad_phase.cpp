#include "reference/broad_phase.h"

#include <algorithm>
#include <iterator>
#include <utility>

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

std::vector<FrameBoxes> sequence_bounds(const Scene& sequence) {
  std::vector<FrameBoxes> all;
  FrameBoxes now(sequence.bodies.size());
  for (const SequenceFrame& frame : sequence.frames) {
    for (const Placement& placement : frame) {
      const auto i = static_cast<std::size_t>(placement.body);
      Body body = sequence.bodies[i];
      if (placement.X_WB) body.X_WB = *placement.X_WB;
      now[i] = placement.X_WB ? std::optional(box(body)) : std::nullopt;
    }
    all.push_back(now);
  }
  return all;
}

PairHistory pair_history(const std::vector<FrameBoxes>& frames) {
  PairHistory history;
  PairSet before;
  for (const FrameBoxes& boxes : frames) {
    PairFrame now{{}, PairSet{}, PairSet{}};
    for (int i = 0; i < static_cast<int>(boxes.size()); ++i) {
      for (int j = i + 1; j < static_cast<int>(boxes.size()); ++j) {
        if (boxes[i] && boxes[j] && overlap(*boxes[i], *boxes[j])) now.pairs.emplace_back(i, j);
      }
    }
    std::ranges::set_difference(now.pairs, before, std::back_inserter(*now.begun));
    std::ranges::set_difference(before, now.pairs, std::back_inserter(*now.ended));
    before = now.pairs;
    history.push_back(std::move(now));
  }
  return history;
}

Rational gap(const ExactBox& a, const ExactBox& b) {
  Rational widest = std::max(b.lo[0] - a.hi[0], a.lo[0] - b.hi[0]);
  for (std::size_t i = 1; i < 3; ++i) widest = std::max({widest, b.lo[i] - a.hi[i], a.lo[i] - b.hi[i]});
  return widest;
}

}  // namespace touchstone::reference
