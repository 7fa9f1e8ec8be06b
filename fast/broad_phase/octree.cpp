#include "fast/broad_phase/octree.h"

#include <algorithm>

namespace touchstone::fast {
namespace {

// A node with at most this many bodies is a leaf. A choice: smaller leaves mean more nodes to visit, larger ones more
// box tests.
constexpr std::size_t largest_leaf = 8;

// Beyond this depth doubles cannot halve the cubes further: bodies this close stay together.
constexpr int greatest_depth = 48;

/// 0 … 7 by bits x, y, z; −1 if the box overlaps a plane through the centre.
int octant(const Aabb& box, const Vec3& centre) {
  int bits = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (box.lo[axis] > centre[axis])
      bits |= 1 << axis;
    else if (box.hi[axis] >= centre[axis])
      return -1;
  }
  return bits;
}

}  // namespace

void Octree::refresh() {
  drop_ended();
  list_present(ids_);
  nodes_.clear();
  if (ids_.size() < 2) return;
  Aabb all = box_[ids_.front()];
  for (const BodyId id : ids_) {
    all.lo = all.lo.cwiseMin(box_[id].lo);
    all.hi = all.hi.cwiseMax(box_[id].hi);
  }
  split(0, ids_.size(), (all.lo + all.hi) / 2, (all.hi - all.lo).maxCoeff() / 2, 0);
  for (std::size_t node = 0; node < nodes_.size(); ++node) report_overlaps(node);
}

void Octree::split(std::size_t first, std::size_t last, const Vec3& centre, double half, int depth) {
  Aabb contents = box_[ids_[first]];
  for (std::size_t i = first; i < last; ++i) {
    contents.lo = contents.lo.cwiseMin(box_[ids_[i]].lo);
    contents.hi = contents.hi.cwiseMax(box_[ids_[i]].hi);
  }
  const std::size_t node = nodes_.size();
  nodes_.push_back({contents, first, last, node + 1});
  if (last - first <= largest_leaf || depth == greatest_depth) return;

  const auto begin = ids_.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = ids_.begin() + static_cast<std::ptrdiff_t>(last);
  auto group = std::partition(begin, end, [&](BodyId id) { return octant(box_[id], centre) < 0; });
  nodes_[node].last = static_cast<std::size_t>(group - ids_.begin());
  for (int o = 0; o < 8; ++o) {
    const auto next = std::partition(group, end, [&](BodyId id) { return octant(box_[id], centre) == o; });
    if (next == group) continue;
    const Vec3 toward((o & 1) != 0 ? 1 : -1, (o & 2) != 0 ? 1 : -1, (o & 4) != 0 ? 1 : -1);
    split(static_cast<std::size_t>(group - ids_.begin()), static_cast<std::size_t>(next - ids_.begin()),
          centre + half / 2 * toward, half / 2, depth + 1);
    group = next;
  }
  nodes_[node].past = nodes_.size();
}

void Octree::report_overlaps(std::size_t node) {
  for (std::size_t i = nodes_[node].first; i < nodes_[node].last; ++i) {
    const BodyId a = ids_[i];
    for (std::size_t j = i + 1; j < nodes_[node].last; ++j)
      if (overlap(box_[a], box_[ids_[j]])) offer(a, ids_[j]);
    for (std::size_t below = node + 1; below < nodes_[node].past;) {
      if (!overlap(nodes_[below].contents, box_[a])) {
        below = nodes_[below].past;
        continue;
      }
      for (std::size_t j = nodes_[below].first; j < nodes_[below].last; ++j)
        if (overlap(box_[a], box_[ids_[j]])) offer(a, ids_[j]);
      ++below;
    }
  }
}

}  // namespace touchstone::fast
