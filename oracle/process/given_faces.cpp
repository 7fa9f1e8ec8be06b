#include "oracle/process/given_faces.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "model/input_error.h"
#include "oracle/process/orientation.h"

namespace touchstone::oracle {
namespace {

using Face = std::vector<int>;

struct Edge {
  int from, to;
  std::size_t face;  ///< the face on its left, seen from outside

  bool operator<(const Edge& other) const { return std::tie(from, to) < std::tie(other.from, other.to); }
  std::string words() const { return std::to_string(from) + '-' + std::to_string(to); }
};

class Surface {
 public:
  explicit Surface(const Polytope& polytope) : polytope_(polytope) {
    for (std::size_t f = 0; f < polytope.faces.size(); ++f) {
      const Face& face = polytope.faces[f];
      for (std::size_t i = 0; i < face.size(); ++i) edges_.push_back({face[i], face[(i + 1) % face.size()], f});
    }
    std::ranges::sort(edges_, {}, [](const Edge& edge) { return std::tie(edge.from, edge.to); });
  }

  void require_closed() const {
    for (std::size_t i = 1; i < edges_.size(); ++i) {
      if (!(edges_[i - 1] < edges_[i]))
        refuse(edges_[i].face, "goes along the edge " + edges_[i].words() + " as another does");
    }
    for (const Edge& edge : edges_) {
      if (!reverse(edge)) refuse(edge.face, "no face on the other side of the edge " + edge.words());
    }
    std::vector<bool> is_corner(polytope_.vertices.size());
    for (const Edge& edge : edges_) is_corner[static_cast<std::size_t>(edge.from)] = true;
    const auto corners = static_cast<std::size_t>(std::ranges::count(is_corner, true));
    if (corners + polytope_.faces.size() != edges_.size() / 2 + 2) {
      throw InputError("faces", "not one closed surface without holes");
    }
  }

  void require_convex() const {
    std::vector<Plane> planes;
    for (std::size_t f = 0; f < polytope_.faces.size(); ++f) {
      planes.push_back(plane_of(f));
      require_convex_polygon(f, planes.back());
    }
    for (const Edge& edge : edges_) {
      for (const int v : polytope_.faces[reverse(edge)->face]) {
        if (v != edge.from && v != edge.to && side(planes[edge.face], v) > 0)
          refuse(edge.face, "vertex " + std::to_string(v) + " of a neighbour rises above it");
      }
    }
  }

 private:
  struct Plane {
    int a, b, c;
    int below;  ///< a vertex
  };

  [[noreturn]] static void refuse(std::size_t face, const std::string& what) {
    throw InputError("faces[" + std::to_string(face) + ']', what);
  }

  const Edge* reverse(const Edge& edge) const {
    const auto found = std::lower_bound(edges_.begin(), edges_.end(), Edge{edge.to, edge.from, 0});
    return found != edges_.end() && found->from == edge.to && found->to == edge.from ? &*found : nullptr;
  }

  int orient(int a, int b, int c, int d) const {
    if (d == a || d == b || d == c) return 0;
    const auto at = [&](int v) { return polytope_.vertices[static_cast<std::size_t>(v)]; };
    return orientation(at(a), at(b), at(c), at(d));
  }

  int side(const Plane& plane, int v) const { return orient(plane.a, plane.b, plane.c, v); }

  /// Describes the plane by three corners that are not on one line, and a vertex that is off the plane.
  Plane plane_of(std::size_t f) const {
    const Face& face = polytope_.faces[f];
    for (std::size_t k = 2; k < face.size(); ++k) {
      for (int v = 0; v < static_cast<int>(polytope_.vertices.size()); ++v) {
        const int where = orient(face[0], face[k - 1], face[k], v);
        if (where > 0)
          refuse(f, "vertex " + std::to_string(v) + " lies outside it; expected counter-clockwise seen from outside");
        if (where < 0) return {face[0], face[k - 1], face[k], v};
      }
    }
    refuse(f, "all its vertices are on one line, or all vertices in its plane");
  }

  void require_convex_polygon(std::size_t f, const Plane& plane) const {
    const Face& face = polytope_.faces[f];
    const std::size_t n = face.size();
    for (std::size_t k = 0; k < n; ++k) {
      if (side(plane, face[k]) != 0)
        refuse(f, "not plane: vertex " + std::to_string(face[k]) + " is off the others' plane");
      if (orient(face[k], face[(k + 1) % n], face[(k + 2) % n], plane.below) > 0) {
        refuse(f, "not a convex polygon at vertex " + std::to_string(face[(k + 1) % n]));
      }
    }
  }

  const Polytope& polytope_;
  std::vector<Edge> edges_;
};

}  // namespace

void require_convex_faces(const Polytope& polytope) {
  const Surface surface(polytope);
  surface.require_closed();
  surface.require_convex();
}

}  // namespace touchstone::oracle
