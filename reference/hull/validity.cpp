#include "reference/validity.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "model/input_error.h"
#include "model/limits.h"
#include "reference/convex_hull.h"

namespace touchstone::reference {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Face = std::vector<int>;

std::string at(const std::string& place, const char* member, std::size_t index) {
  return place + "." + member + "[" + std::to_string(index) + "]";
}

/// A polytope under scrutiny: its vertices as CGAL points, and its place in the scene for messages.
class Scrutiny {
 public:
  Scrutiny(Polytope& polytope, std::string place) : polytope_(polytope), place_(std::move(place)) {
    for (const Vec3& v : polytope.vertices) points_.emplace_back(v.x(), v.y(), v.z());
  }

  void derive_faces() {
    Polytope hull;
    try {
      hull = convex_hull(polytope_.vertices);
    } catch (const InputError&) {
      throw InputError(place_ + ".vertices", "all in one plane: a solid needs 4 that are not");
    }
    // The hull keeps the input's order, so its vertices are found again by walking both lists.
    std::vector<int> input_index;
    for (std::size_t i = 0; i < polytope_.vertices.size(); ++i) {
      if (input_index.size() < hull.vertices.size() && polytope_.vertices[i] == hull.vertices[input_index.size()]) {
        input_index.push_back(static_cast<int>(i));
      }
    }
    for (Face& face : hull.faces) {
      for (int& v : face) v = input_index[static_cast<std::size_t>(v)];
    }
    polytope_.faces = std::move(hull.faces);
    require_vertices_on_boundary();
  }

  void check_faces() const {
    for (std::size_t f = 0; f < polytope_.faces.size(); ++f) check_face(f);
    require_closed();
    require_vertices_on_boundary();
  }

 private:
  const Point& point(int i) const { return points_[static_cast<std::size_t>(i)]; }

  /// Three corners of the face that are not on a line: its plane.
  std::array<int, 3> plane_of(const Face& face, const std::string& face_place) const {
    for (std::size_t k = 2; k < face.size(); ++k) {
      if (!CGAL::collinear(point(face[0]), point(face[k - 1]), point(face[k]))) return {face[0], face[k - 1], face[k]};
    }
    throw InputError(face_place, "all its vertices are on one line");
  }

  CGAL::Orientation side(const std::array<int, 3>& plane, int vertex) const {
    return CGAL::orientation(point(plane[0]), point(plane[1]), point(plane[2]), point(vertex));
  }

  void check_face(std::size_t f) const {
    const Face& face = polytope_.faces[f];
    const std::string face_place = at(place_, "faces", f);
    const auto plane = plane_of(face, face_place);
    for (const int v : face) {
      if (side(plane, v) != CGAL::COPLANAR) {
        throw InputError(face_place, "not plane: vertex " + std::to_string(v) + " is off the plane of the others");
      }
    }
    int above = -1;
    int below = -1;
    for (int v = 0; v < static_cast<int>(points_.size()); ++v) {
      const auto where = side(plane, v);
      if (where == CGAL::POSITIVE) above = v;
      if (where == CGAL::NEGATIVE) below = v;
    }
    if (above >= 0 && below < 0) throw InputError(face_place, "wound clockwise seen from outside");
    if (above >= 0) {
      throw InputError(face_place,
                       "not a face of the convex hull: vertex " + std::to_string(above) + " lies outside its plane");
    }
    if (below < 0) throw InputError(place_ + ".vertices", "all in one plane: a solid needs 4 that are not");
    require_convex(face, face_place, below);
  }

  /// Seen from a vertex below the face, the outline turns one way only.
  void require_convex(const Face& face, const std::string& face_place, int below) const {
    const std::size_t n = face.size();
    for (std::size_t k = 0; k < n; ++k) {
      const auto turn =
          CGAL::orientation(point(face[k]), point(face[(k + 1) % n]), point(face[(k + 2) % n]), point(below));
      if (turn == CGAL::POSITIVE) {
        throw InputError(face_place, "not a convex polygon at vertex " + std::to_string(face[(k + 1) % n]));
      }
    }
  }

  void require_closed() const {
    std::map<std::pair<int, int>, std::size_t> left;
    for (std::size_t f = 0; f < polytope_.faces.size(); ++f) {
      const Face& face = polytope_.faces[f];
      for (std::size_t k = 0; k < face.size(); ++k) {
        const std::pair edge{face[k], face[(k + 1) % face.size()]};
        if (!left.emplace(edge, f).second) {
          throw InputError(at(place_, "faces", f),
                           "goes along the edge " + words(edge) + " as faces[" + std::to_string(left[edge]) + "] does");
        }
      }
    }
    for (const auto& [edge, f] : left) {
      if (!left.contains({edge.second, edge.first})) {
        throw InputError(at(place_, "faces", f), "no face on the other side of the edge " + words(edge));
      }
    }
    require_covered_once(left.size());
  }

  /// Faces that pass the checks above cover the hull's boundary d ≥ 1 times over: V − E + F of the named vertices, the
  /// edges and the faces tells how often. Let s_v be the sheets that meet at vertex v and t_f the turns of face f's
  /// outline; then Σ s_v − E + F = 2d − Σ (t_f − 1) (Euler, face by face), so V − E + F = 2d − Σ (t_f − 1) − Σ (s_v −
  /// 1). Every extreme vertex, and there are 4 or more, has s_v = d: the right-hand side is 2 when d = 1, and at most 4
  /// − 2d ≤ 0 otherwise.
  void require_covered_once(std::size_t directed_edges) const {
    std::set<int> named;
    for (const Face& face : polytope_.faces) named.insert(face.begin(), face.end());
    if (named.size() + polytope_.faces.size() != directed_edges / 2 + 2) {
      throw InputError(place_ + ".faces", "they cover the boundary more than once");
    }
  }

  /// Faces of a hull cover its boundary, so a vertex that none names is inside unless it is in some face's plane.
  void require_vertices_on_boundary() const {
    std::set<int> named;
    for (const Face& face : polytope_.faces) named.insert(face.begin(), face.end());
    for (int v = 0; v < static_cast<int>(points_.size()); ++v) {
      if (named.contains(v)) continue;
      const bool on_boundary = std::any_of(polytope_.faces.begin(), polytope_.faces.end(), [&](const Face& face) {
        return side(plane_of(face, place_), v) == CGAL::COPLANAR;
      });
      if (!on_boundary) throw InputError(at(place_, "vertices", static_cast<std::size_t>(v)), "lies inside the hull");
    }
  }

  static std::string words(const std::pair<int, int>& edge) {
    return std::to_string(edge.first) + "-" + std::to_string(edge.second);
  }

  Polytope& polytope_;
  std::string place_;
  std::vector<Point> points_;
};

template <class AnyShape>
void complete(AnyShape& shape, const std::string& place) {
  if (auto* polytope = std::get_if<Polytope>(&shape)) {
    Scrutiny scrutiny(*polytope, place);
    if (polytope->faces.empty()) {
      scrutiny.derive_faces();
    } else {
      scrutiny.check_faces();
    }
  }
}

}  // namespace

Scene completed(Scene scene) {
  validate(scene);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const std::string place = "bodies[" + std::to_string(b) + "].shape";
    complete(scene.bodies[b].shape, place);
    if (auto* compound = std::get_if<Compound>(&scene.bodies[b].shape)) {
      for (std::size_t p = 0; p < compound->parts.size(); ++p)
        complete(compound->parts[p].shape, at(place, "parts", p) + ".shape");
    }
  }
  return scene;
}

}  // namespace touchstone::reference
