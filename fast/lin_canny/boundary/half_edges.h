// The half-edges of a closed surface of polygons.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace touchstone::fast::lin_canny {

/// Polygons by the indices of their corners, one polygon after the other.
struct Loops {
  std::vector<int> corners;
  std::vector<int> first{0};  ///< by polygon: its first corner; one more: their number

  std::size_t count() const { return first.size() - 1; }
  std::span<const int> operator[](std::size_t i) const {
    const auto begin = static_cast<std::size_t>(first[i]), end = static_cast<std::size_t>(first[i + 1]);
    return std::span(corners).subspan(begin, end - begin);
  }
  void add(std::span<const int> loop) {
    corners.insert(corners.end(), loop.begin(), loop.end());
    first.push_back(static_cast<int>(corners.size()));
  }
};

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
  HalfEdges(const Loops& loops, std::size_t vertices);

  const std::vector<HalfEdge>& sorted() const { return sorted_; }
  /// Of the half-edge sorted()[i].
  const HalfEdge& twin(std::size_t i) const { return sorted_[static_cast<std::size_t>(twin_[i])]; }
  /// How many half-edges come from vertex v, which is the number of faces there.
  std::size_t degree(std::size_t v) const { return first_[v + 1] - first_[v]; }

 private:
  void count(const Loops& loops);
  void sort(const Loops& loops);
  bool link();
  int find(int from, int to) const;

  std::vector<HalfEdge> sorted_;
  std::vector<std::size_t> first_;  ///< by vertex: its first half-edge in sorted_; one more: their number
  std::vector<int> twin_;
};

}  // namespace touchstone::fast::lin_canny
