// A closed surface of triangles that grows corner by corner: its topology.
#pragma once

#include <array>
#include <concepts>
#include <vector>

namespace touchstone::fast::penetration {

/// Corners are numbered; their positions are the caller's. A triangle that is replaced is dead, and its number is used
/// again.
class Triangulation {
 public:
  struct Triangle {
    std::array<int, 3> corners{};     ///< counter-clockwise, seen from outside
    std::array<int, 3> neighbours{};  ///< across the edge from corner i to the next
    bool is_dead = false;
  };

  bool empty() const { return triangles_.empty(); }
  int size() const { return static_cast<int>(triangles_.size()); }  ///< dead ones included
  const Triangle& operator[](int t) const { return triangles_[static_cast<std::size_t>(t)]; }

  void clear();
  /// The tetrahedron of the corners 0 to 3, where 3 is below the triangle 0 1 2, seen from outside.
  void start();
  /// Replaces a connected set of triangles that are visible from a new corner, `from` and what `is_visible(t)` accepts,
  /// by a cone from it. Returns the new triangles; none, and nothing has changed, if the outline of the set is not one
  /// cycle. Valid until the next call.
  template <std::predicate<int> IsVisible>
  const std::vector<int>& insert(int apex, int from, IsVisible&& is_visible) {
    visible_.assign(1, from);
    triangles_[static_cast<std::size_t>(from)].is_dead = true;
    for (std::size_t k = 0; k < visible_.size(); ++k) {
      for (const int beyond : std::array((*this)[visible_[k]].neighbours)) {
        if ((*this)[beyond].is_dead || !is_visible(beyond)) continue;
        triangles_[static_cast<std::size_t>(beyond)].is_dead = true;
        visible_.push_back(beyond);
      }
    }
    return replace_visible(apex);
  }

 private:
  struct Edge {
    int tail = 0;
    int head = 0;
    int beyond = 0;  ///< the triangle that stays
  };

  const std::vector<int>& replace_visible(int apex);
  void find_outline();
  bool is_one_cycle(int corners);
  int new_triangle(int a, int b, int c);

  std::vector<Triangle> triangles_;
  std::vector<int> unused_;  ///< dead triangles
  // Of insert:
  std::vector<int> visible_;
  std::vector<Edge> outline_;
  std::vector<int> starts_at_;  ///< by corner: the edge of the outline, then the new triangle, that starts there
  std::vector<int> fresh_;
};

}  // namespace touchstone::fast::penetration
