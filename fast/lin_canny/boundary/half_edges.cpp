#include "fast/lin_canny/boundary/half_edges.h"

#include <algorithm>
#include <string>

#include "model/input_error.h"

namespace touchstone::fast::lin_canny {
namespace {

[[noreturn]] void refuse_face(const std::string& what) { throw InputError("shape.faces", what); }

}  // namespace

HalfEdges::HalfEdges(const Loops& loops, std::size_t vertices) : first_(vertices + 1) {
  count(loops);
  sort(loops);
  if (link()) return;
  for (const HalfEdge& edge : sorted_) {
    if (find(edge.to, edge.from) >= 0) continue;
    refuse_face("edge " + std::to_string(edge.to) + "-" + std::to_string(edge.from) + " is not met exactly once");
  }
}

void HalfEdges::count(const Loops& loops) {
  for (std::size_t face = 0; face < loops.count(); ++face) {
    const std::span<const int> loop = loops[face];
    if (loop.size() < 3) refuse_face("a face of fewer than three vertices");
    for (const int v : loop) {
      if (v < 0 || static_cast<std::size_t>(v) + 1 >= first_.size()) refuse_face("no vertex " + std::to_string(v));
      ++first_[static_cast<std::size_t>(v) + 1];
    }
  }
  for (std::size_t v = 0; v + 1 < first_.size(); ++v) first_[v + 1] += first_[v];
}

/// Into the ranges of the vertices they come from, which have few half-edges each.
void HalfEdges::sort(const Loops& loops) {
  sorted_.resize(first_.back());
  std::vector<std::size_t> next = first_;
  int place = 0;
  for (std::size_t face = 0; face < loops.count(); ++face) {
    const std::span<const int> loop = loops[face];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const int to = loop[i + 1 < loop.size() ? i + 1 : 0];
      sorted_[next[static_cast<std::size_t>(loop[i])]++] = {loop[i], to, static_cast<int>(face), place++};
    }
  }
  const auto by_head = [](const HalfEdge& a, const HalfEdge& b) { return a.to < b.to; };
  for (std::size_t v = 0; v + 1 < first_.size(); ++v) {
    std::sort(sorted_.begin() + static_cast<std::ptrdiff_t>(first_[v]),
              sorted_.begin() + static_cast<std::ptrdiff_t>(first_[v + 1]), by_head);
  }
}

/// Finds the twins, an edge at a time; false if an edge does not occur exactly once in each direction.
bool HalfEdges::link() {
  twin_.assign(sorted_.size(), -1);
  std::size_t linked = 0;
  for (std::size_t i = 0; i < sorted_.size(); ++i) {
    const HalfEdge& edge = sorted_[i];
    if (edge.from > edge.to) continue;
    const int back = find(edge.to, edge.from);
    if (back < 0 || twin_[static_cast<std::size_t>(back)] >= 0) return false;
    twin_[i] = back;
    twin_[static_cast<std::size_t>(back)] = static_cast<int>(i);
    linked += 2;
  }
  return linked == sorted_.size();
}

/// The only half-edge from `from` to `to`; -1 if there is none, or more than one.
int HalfEdges::find(int from, int to) const {
  const auto v = static_cast<std::size_t>(from);
  const HalfEdge* const begin = sorted_.data() + first_[v];
  const HalfEdge* const end = sorted_.data() + first_[v + 1];
  const HalfEdge* const found =
      std::lower_bound(begin, end, to, [](const HalfEdge& a, int head) { return a.to < head; });
  const bool once = found != end && found->to == to && (found + 1 == end || (found + 1)->to != to);
  return once ? static_cast<int>(found - sorted_.data()) : -1;
}

}  // namespace touchstone::fast::lin_canny
