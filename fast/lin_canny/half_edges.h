// The half-edges of a closed surface of polygons.
#pragma once

#include <cstddef>
#include <vector>

namespace touchstone::fast::lin_canny {

struct HalfEdge {
  int from = 0;
  int to = 0;
  int face = 0;
  int place = 0;  ///< of `from` in the sequence of all loops
};

/// Sorted by `from`, then by `to`; each with its twin, the same edge in the other direction.
class HalfEdges {
 public:
  /// `loops`: the corners of each face, as indices of `vertices` vertices. Throws InputError if a face has fewer than
  /// three corners, an index is out of range, or an edge does not occur exactly once in each direction.
  HalfEdges(const std::vector<std::vector<int>>& loops, std::size_t vertices);

  const std::vector<HalfEdge>& sorted() const { return sorted_; }
  /// Of the half-edge sorted()[i].
  const HalfEdge& twin(std::size_t i) const { return sorted_[twin_[i]]; }

 private:
  void sort(const std::vector<std::vector<int>>& loops);
  std::size_t twin_of(const HalfEdge& edge) const;

  std::vector<HalfEdge> sorted_;
  std::vector<std::size_t> first_;  ///< by vertex: its first half-edge in sorted_; one more: their number
  std::vector<std::size_t> twin_;
};

}  // namespace touchstone::fast::lin_canny
