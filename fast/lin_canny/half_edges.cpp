#include "fast/lin_canny/half_edges.h"

#include <algorithm>
#include <string>

#include "model/input_error.h"

namespace touchstone::fast::lin_canny {
namespace {

[[noreturn]] void refuse_face(const std::string& what) { throw InputError("shape.faces", what); }

}  // namespace

HalfEdges::HalfEdges(const std::vector<std::vector<int>>& loops, std::size_t vertices) : first_(vertices + 1) {
  for (const std::vector<int>& loop : loops) {
    if (loop.size() < 3) refuse_face("a face of fewer than three vertices");
    for (const int v : loop) {
      if (v < 0 || static_cast<std::size_t>(v) >= vertices) refuse_face("no vertex " + std::to_string(v));
      ++first_[static_cast<std::size_t>(v) + 1];
    }
  }
  for (std::size_t v = 0; v < vertices; ++v) first_[v + 1] += first_[v];
  sort(loops);
  twin_.reserve(sorted_.size());
  for (const HalfEdge& edge : sorted_) twin_.push_back(twin_of(edge));
}

/// Into the ranges of the vertices they come from, which have few half-edges each.
void HalfEdges::sort(const std::vector<std::vector<int>>& loops) {
  sorted_.resize(first_.back());
  std::vector<std::size_t> next = first_;
  int place = 0;
  for (std::size_t face = 0; face < loops.size(); ++face) {
    const std::vector<int>& loop = loops[face];
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

std::size_t HalfEdges::twin_of(const HalfEdge& edge) const {
  const auto v = static_cast<std::size_t>(edge.to);
  const HalfEdge* const end = sorted_.data() + first_[v + 1];
  const HalfEdge* const found =
      std::lower_bound(sorted_.data() + first_[v], end, edge.from, [](const HalfEdge& a, int to) { return a.to < to; });
  const bool once = found != end && found->to == edge.from && (found + 1 == end || (found + 1)->to != edge.from);
  if (!once) {
    refuse_face("edge " + std::to_string(edge.to) + "-" + std::to_string(edge.from) + " is not met exactly once");
  }
  return static_cast<std::size_t>(found - sorted_.data());
}

}  // namespace touchstone::fast::lin_canny
