#include "reference/convex_hull.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "model/input_error.h"

namespace touchstone::reference {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

bool before(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

/// Triangles of the hull as triples of input indices.
std::vector<std::array<int, 3>> hull_triangles(const std::vector<Vec3>& points) {
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](int i, int j) { return before(points[i], points[j]) || (points[i] == points[j] && i < j); });
  std::vector<Point> input;
  input.reserve(points.size());
  for (const Vec3& p : points) input.emplace_back(p.x(), p.y(), p.z());

  Mesh mesh;
  CGAL::convex_hull_3(input.begin(), input.end(), mesh);
  const auto index_of = [&](const Point& p) {
    const Vec3 v(p.x(), p.y(), p.z());
    return *std::lower_bound(order.begin(), order.end(), v, [&](int i, const Vec3& w) { return before(points[i], w); });
  };
  std::vector<std::array<int, 3>> triangles;
  for (const auto face : mesh.faces()) {
    std::array<int, 3> triangle{};
    int corner = 0;
    for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face)))
      triangle[corner++] = index_of(mesh.point(vertex));
    triangles.push_back(triangle);
  }
  return triangles;
}

/// A directed edge and the triangle on its left.
struct HalfEdge {
  std::pair<int, int> edge;
  int left;
};

std::vector<HalfEdge> half_edges(const std::vector<std::array<int, 3>>& triangles) {
  std::vector<HalfEdge> all;
  all.reserve(3 * triangles.size());
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) all.push_back({{triangles[t][k], triangles[t][(k + 1) % 3]}, t});
  }
  std::ranges::sort(all, {}, &HalfEdge::edge);
  return all;
}

/// The edges of an outline: `from` is followed by `to`.
struct OutlineEdge {
  int face;
  int from;
  int to;

  auto operator<=>(const OutlineEdge&) const = default;
};

/// The outlines of the plane faces: coplanar triangles are joined and their common edges removed.
std::vector<std::vector<int>> merged(const std::vector<Vec3>& points,
                                     const std::vector<std::array<int, 3>>& triangles) {
  const auto point = [&](int i) { return Point(points[i].x(), points[i].y(), points[i].z()); };
  const std::vector<HalfEdge> all = half_edges(triangles);
  const auto right_of = [&](const HalfEdge& e) {
    return std::ranges::lower_bound(all, std::pair{e.edge.second, e.edge.first}, {}, &HalfEdge::edge)->left;
  };
  std::vector<int> group(triangles.size());
  std::iota(group.begin(), group.end(), 0);
  const auto root = [&](int t) {
    while (group[t] != t) t = group[t] = group[group[t]];
    return t;
  };
  for (const HalfEdge& e : all) {
    if (e.edge.first > e.edge.second) continue;  // its twin was seen
    const int right = right_of(e);
    const auto& a = triangles[e.left];
    const int apex =
        std::accumulate(triangles[right].begin(), triangles[right].end(), 0) - e.edge.first - e.edge.second;
    if (CGAL::coplanar(point(a[0]), point(a[1]), point(a[2]), point(apex))) group[root(e.left)] = root(right);
  }
  std::vector<OutlineEdge> outlines;
  for (const HalfEdge& e : all) {
    if (root(e.left) != root(right_of(e))) outlines.push_back({root(e.left), e.edge.first, e.edge.second});
  }
  std::ranges::sort(outlines);
  std::vector<std::vector<int>> faces;
  for (auto first = outlines.begin(); first != outlines.end();) {
    const auto end = std::find_if(first, outlines.end(), [&](const OutlineEdge& e) { return e.face != first->face; });
    std::vector<int> outline;
    auto at = first;
    do {
      outline.push_back(at->from);
      at = std::lower_bound(first, end, at->to, [](const OutlineEdge& e, int from) { return e.from < from; });
    } while (at != first);
    faces.push_back(std::move(outline));
    first = end;
  }
  return faces;
}

/// Drops the vertices in the middle of a straight edge; such a vertex is one in both faces of the edge.
void drop_collinear(const std::vector<Vec3>& points, std::vector<int>& face) {
  const auto point = [&](int i) { return Point(points[i].x(), points[i].y(), points[i].z()); };
  std::vector<int> corners;
  const std::size_t n = face.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (!CGAL::collinear(point(face[(k + n - 1) % n]), point(face[k]), point(face[(k + 1) % n])))
      corners.push_back(face[k]);
  }
  face = std::move(corners);
}

/// Each face starts at its least vertex, the faces are sorted, and the vertices are those in use, in the order of the
/// input.
Polytope canonical(const std::vector<Vec3>& points, std::vector<std::vector<int>> faces) {
  constexpr int unused = -1;
  std::vector<int> renamed(points.size(), unused);
  for (const auto& face : faces) {
    for (const int v : face) renamed[v] = 0;
  }
  Polytope hull;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (renamed[v] == unused) continue;
    renamed[v] = static_cast<int>(hull.vertices.size());
    hull.vertices.push_back(points[v]);
  }
  for (auto& face : faces) {
    for (int& v : face) v = renamed[v];
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  }
  std::sort(faces.begin(), faces.end());
  hull.faces = std::move(faces);
  return hull;
}

void require_volume(const std::vector<Vec3>& points) {
  const auto point = [&](std::size_t i) { return Point(points[i].x(), points[i].y(), points[i].z()); };
  std::array<std::size_t, 4> corner{};
  int found = 1;
  for (std::size_t i = 1; i < points.size() && found < 4; ++i) {
    corner[found] = i;
    const bool independent = found == 1   ? points[i] != points[0]
                             : found == 2 ? !CGAL::collinear(point(0), point(corner[1]), point(i))
                                          : !CGAL::coplanar(point(0), point(corner[1]), point(corner[2]), point(i));
    if (independent) ++found;
  }
  if (found < 4) {
    throw InputError("points", points.size() < 4 ? "fewer than 4: a solid needs 4 that are not in one plane"
                                                 : "all in one plane: a solid needs 4 that are not");
  }
}

}  // namespace

Polytope convex_hull(const std::vector<Vec3>& points) {
  require_volume(points);
  auto faces = merged(points, hull_triangles(points));
  for (auto& face : faces) drop_collinear(points, face);
  return canonical(points, std::move(faces));
}

}  // namespace touchstone::reference
