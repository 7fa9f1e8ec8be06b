#include "oracle/process/hull_faces.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "model/input_error.h"
#include "oracle/process/orientation.h"

namespace touchstone::oracle {
namespace {

using Face = std::vector<int>;
using DirectedEdge = std::pair<int, int>;

class GiftWrapping {
 public:
  explicit GiftWrapping(const std::vector<Vec3>& vertices) : vertices_(vertices), on_boundary_(vertices.size()) {}

  std::vector<Face> faces() {
    std::vector<DirectedEdge> open = {first_edge()};
    while (!open.empty()) {
      const DirectedEdge edge = open.back();
      open.pop_back();
      if (wrapped_.contains(edge)) continue;
      const Face face = face_left_of(edge);
      for (std::size_t i = 0; i < face.size(); ++i) {
        const DirectedEdge side{face[i], face[(i + 1) % face.size()]};
        wrapped_.insert(side);
        open.emplace_back(side.second, side.first);
      }
      faces_.push_back(face);
    }
    require_all_on_boundary();
    return canonical();
  }

 private:
  const Vec3& at(int i) const { return vertices_[static_cast<std::size_t>(i)]; }
  int count() const { return static_cast<int>(vertices_.size()); }

  /// An exact zero is the most expensive result. For the three vertices of the plane it is known in advance.
  int side(int a, int b, int c, int d) const {
    return d == a || d == b || d == c ? 0 : orientation(at(a), at(b), at(c), at(d));
  }

  bool before(int i, int j) const {
    return std::lexicographical_compare(at(i).begin(), at(i).end(), at(j).begin(), at(j).end());
  }

  [[noreturn]] static void refuse_flat() {
    throw InputError("vertices", "all in one plane: a solid needs 4 that are not");
  }

  /// Seen from above: v is left of the line from a to b (1), right of it (-1), or on it (0).
  int level_turn(int a, int b, int v) const {
    const auto level = [&](int i) { return Vec3(at(i).x(), at(i).y(), 0); };
    return orientation(level(a), level(b), level(v), level(a) + Vec3(0, 0, 1));
  }

  bool is_vertical(int a, int b) const { return at(a).x() == at(b).x() && at(a).y() == at(b).y(); }

  /// Returns two vertices on the line of an edge. All vertices lie on the left of some vertical plane through the least
  /// vertex, or in it. The least of the vertices in that plane is a corner of their outline, and the edge belongs to
  /// it.
  DirectedEdge first_edge() const {
    int corner = 0;
    for (int v = 1; v < count(); ++v) {
      if (before(v, corner)) corner = v;
    }
    int beside = -1;
    for (int v = 0; v < count(); ++v) {
      if (!is_vertical(corner, v) && (beside < 0 || level_turn(corner, beside, v) < 0)) beside = v;
    }
    if (beside < 0) refuse_flat();
    int apex = -1;
    for (int v = 0; v < count(); ++v) {
      if (level_turn(corner, beside, v) != 0) apex = v;
    }
    if (apex < 0) refuse_flat();
    int next = beside;
    for (int v = 0; v < count(); ++v) {
      if (v != corner && level_turn(corner, beside, v) == 0 && side(corner, next, v, apex) > 0) next = v;
    }
    return {corner, next};
  }

  /// The outline of the vertices in the plane through the edge that has no vertex on its outer side.
  Face face_left_of(const DirectedEdge& edge) {
    const auto [a, b] = edge;
    int c = 0;
    while (c < count() && collinear(at(a), at(b), at(c))) ++c;
    if (c == count()) refuse_flat();
    for (int v = 0; v < count(); ++v) {
      if (side(a, b, c, v) > 0) c = v;
    }
    std::vector<int> in_plane;
    int inside = -1;
    for (int v = 0; v < count(); ++v) {
      if (side(a, b, c, v) == 0) {
        in_plane.push_back(v);
        on_boundary_[static_cast<std::size_t>(v)] = true;
      } else {
        inside = v;
      }
    }
    if (inside < 0) refuse_flat();
    return outline(in_plane, inside);
  }

  /// Goes from corner to corner; of several vertices on one straight line, it takes the last.
  Face outline(const std::vector<int>& in_plane, int inside) const {
    const int first = *std::ranges::min_element(in_plane, [&](int i, int j) { return before(i, j); });
    Face corners;
    int corner = first;
    do {
      corners.push_back(corner);
      int next = corner;
      for (const int v : in_plane) {
        if (v == corner) continue;
        const int right = next == corner ? 1 : side(corner, next, v, inside);
        if (right > 0 || (right == 0 && before(corner, next) == before(next, v))) next = v;
      }
      corner = next;
    } while (corner != first);
    return corners;
  }

  void require_all_on_boundary() const {
    const auto hidden = std::ranges::find(on_boundary_, false);
    if (hidden == on_boundary_.end()) return;
    throw InputError("vertices[" + std::to_string(hidden - on_boundary_.begin()) + "]", "lies inside the hull");
  }

  std::vector<Face> canonical() const {
    std::vector<Face> faces = faces_;
    for (Face& face : faces) std::rotate(face.begin(), std::ranges::min_element(face), face.end());
    std::ranges::sort(faces);
    return faces;
  }

  const std::vector<Vec3>& vertices_;
  std::vector<bool> on_boundary_;
  std::set<DirectedEdge> wrapped_;
  std::vector<Face> faces_;
};

}  // namespace

std::vector<std::vector<int>> hull_faces(const std::vector<Vec3>& vertices) { return GiftWrapping(vertices).faces(); }

}  // namespace touchstone::oracle
