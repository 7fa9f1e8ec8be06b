// A hull's adjacency is consistent, its faces are maximal, and what is not a solid is refused.
#include "fast/lin_canny/hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "fast/lin_canny/rotation.h"
#include "model/input_error.h"
#include "tests/catch.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::fast::lin_canny {
namespace {

using tests::Dice;

Polytope cube_of_triangles() {
  Polytope cube;
  for (int i = 0; i < 8; ++i) cube.vertices.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  for (const std::vector<int>& q : std::vector<std::vector<int>>{
           {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}) {
    cube.faces.push_back({q[0], q[1], q[2]});
    cube.faces.push_back({q[0], q[2], q[3]});
  }
  return cube;
}

/// Each edge at v once, in any order; the last one fills the lanes that are left.
void check_spokes(const Hull& hull, int v) {
  std::vector<int> edges;
  for (const Hull::Spokes& some : hull.spokes(v)) {
    CHECK(reinterpret_cast<std::uintptr_t>(&some) % 64 == 0);
    for (std::size_t lane = 0; lane < Hull::Spokes::lanes; ++lane) {
      const Hull::Edge& edge = hull.edge(hull.edge_of(some, lane));
      CHECK(edge.tail == std::min(v, some.other[lane]));
      CHECK(edge.head == std::max(v, some.other[lane]));
      const Vec3 away = (hull.vertex(some.other[lane]) - hull.vertex(v)).normalized();
      CHECK((Vec3(some.x[lane], some.y[lane], some.z[lane]) - away).norm() <= 0x1p-24);
      edges.push_back(hull.edge_of(some, lane));
    }
  }
  const auto padding = std::unique(edges.begin(), edges.end());
  CHECK(edges.end() - padding < static_cast<std::ptrdiff_t>(Hull::Spokes::lanes));
  std::vector<int> at_v;
  for (int e = 0; e < hull.edge_count(); ++e) {
    if (hull.edge(e).tail == v || hull.edge(e).head == v) at_v.push_back(e);
  }
  CHECK(std::vector<int>(edges.begin(), padding) == at_v);
}

void check_neighbourhoods(const Hull& hull) {
  CHECK(hull.vertex_count() - hull.edge_count() + hull.face_count() == 2);
  for (int f = 0; f < hull.face_count(); ++f) {
    const Hull::Face& face = hull.face(f);
    CHECK(std::abs(face.normal.norm() - 1) <= 8 * u);
    for (int v = 0; v < hull.vertex_count(); ++v) {
      CHECK(face.normal.dot(hull.vertex(v)) <= face.height + 8 * u * hull.radius());
    }
    const std::span<const Hull::Corner> corners = hull.corners(face);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Hull::Edge& side = hull.edge(corners[i].side);
      const int next = corners[(i + 1) % corners.size()].vertex;
      CHECK(side.tail == std::min(corners[i].vertex, next));
      CHECK(side.head == std::max(corners[i].vertex, next));
      CHECK(side.face[side.tail == corners[i].vertex ? 0 : 1] == f);
      CHECK(std::abs(face.normal.dot(hull.vertex(next)) - face.height) <= 64 * u * hull.radius());
    }
  }
  for (int e = 0; e < hull.edge_count(); ++e) {
    const Hull::Edge& edge = hull.edge(e);
    CHECK(edge.tail < edge.head);
    CHECK(edge.face[0] != edge.face[1]);
  }
  for (int v = 0; v < hull.vertex_count(); ++v) check_spokes(hull, v);
}

TEST_CASE("neighbourhoods of boxes, lattice solids and round ones hang together") {
  check_neighbourhoods(Hull(Box{Vec3(1, 2, 3)}));
  check_neighbourhoods(Hull(tests::lattice_prism(325, 8)));
  check_neighbourhoods(Hull(tests::lattice_sphere(14)));
  Dice dice(3);
  for (int i = 0; i < 10; ++i) check_neighbourhoods(Hull(tests::round_hull(dice, 30)));
}

// A disc that a rotation rounds: its faces are nearly coplanar and their normals off by rounding over their width. So a
// vertex far from a narrow face may be higher along its normal than its corners are.
TEST_CASE("the height of a face is that of the highest vertex along its normal, also if it is no corner of it") {
  Dice dice(7);
  int beside = 0;
  for (int i = 0; i < 10; ++i) {
    const Vec3 about = dice.in_cube();
    const Mat3 R = rotation({1, about.x(), about.y(), about.z()});
    std::vector<Vec3> points;
    for (int k = 0; k < 24; ++k) {
      const Vec3 p = dice.in_cube();
      points.push_back(R * Vec3(p.x(), p.y(), 0));
    }
    const Hull hull(reference::convex_hull(points));
    for (int f = 0; f < hull.face_count(); ++f) {
      const Hull::Face& face = hull.face(f);
      double highest = face.normal.dot(hull.vertex(hull.corners(face)[0].vertex)), corner = highest;
      for (int v = 0; v < hull.vertex_count(); ++v) highest = std::max(highest, face.normal.dot(hull.vertex(v)));
      for (const Hull::Corner& each : hull.corners(face))
        corner = std::max(corner, face.normal.dot(hull.vertex(each.vertex)));
      CHECK(face.height == highest);
      beside += highest > corner + 16 * u * hull.radius();
    }
  }
  CHECK(beside > 0);
}

TEST_CASE("coplanar neighbours are one face, and corners that are none go") {
  const Hull cube(cube_of_triangles());
  CHECK(cube.vertex_count() == 8);
  CHECK(cube.edge_count() == 12);
  CHECK(cube.face_count() == 6);
  check_neighbourhoods(cube);

  Polytope with_midpoint = cube_of_triangles();  // edge 0-1 is split at 8, in both faces at it
  with_midpoint.vertices.emplace_back(0, -1, -1);
  std::vector<std::vector<int>> faces;
  for (const std::vector<int>& f : with_midpoint.faces) {
    std::vector<int> cut;
    for (std::size_t i = 0; i < 3; ++i) {
      cut.push_back(f[i]);
      const int next = f[(i + 1) % 3];
      if (std::min(f[i], next) == 0 && std::max(f[i], next) == 1) cut.push_back(8);
    }
    faces.push_back(cut);
  }
  with_midpoint.faces = faces;
  const Hull same(with_midpoint);
  CHECK(same.vertex_count() == 8);
  CHECK(same.edge_count() == 12);
  for (int v = 0; v < 8; ++v) CHECK(same.vertex(v) == cube.vertex(v));
}

TEST_CASE("corners keep their order where vertices before them are none") {
  Polytope cube = cube_of_triangles();  // 0 becomes the middle of the face x = -1, which no face names
  cube.vertices.insert(cube.vertices.begin(), Vec3(-1, 0, 0));
  for (std::vector<int>& face : cube.faces) {
    for (int& v : face) ++v;
  }
  const Hull hull(cube);
  CHECK(hull.vertex_count() == 8);
  CHECK(hull.face_count() == 6);
  for (int v = 0; v < 8; ++v) CHECK(hull.vertex(v) == cube.vertices[static_cast<std::size_t>(v) + 1]);
  check_neighbourhoods(hull);
}

TEST_CASE("coplanar neighbours are one face, whichever two vertices are exchanged") {
  for (int a = 0; a < 8; ++a) {
    for (int b = 0; b < a; ++b) {
      Polytope cube = cube_of_triangles();
      std::swap(cube.vertices[static_cast<std::size_t>(a)], cube.vertices[static_cast<std::size_t>(b)]);
      for (std::vector<int>& face : cube.faces) {
        for (int& v : face) v = v == a ? b : v == b ? a : v;
      }
      CHECK(Hull(cube).face_count() == 6);
    }
  }
}

TEST_CASE("copies share the block, and outlive the first") {
  auto first = std::make_unique<Hull>(cube_of_triangles());
  const Vec3* const vertices = first->vertices().data();
  const Hull copy = *first;
  first.reset();
  CHECK(copy.vertices().data() == vertices);
  check_neighbourhoods(copy);
}

TEST_CASE("one ulp out of plane is another face") {
  Polytope bent = cube_of_triangles();
  bent.vertices[7].z() = 1 + 0x1p-52;
  const Hull hull(bent);
  CHECK(hull.face_count() > 6);
  CHECK(hull.vertex_count() == 8);
}

TEST_CASE("what is no solid is refused, with its place") {
  const Polytope cube = cube_of_triangles();
  const auto refused = [&](auto&& spoil) {
    Polytope bad = cube;
    spoil(bad);
    CHECK_THROWS_AS(Hull(bad), InputError);
  };
  refused([](Polytope& p) { p.faces.clear(); });
  refused([](Polytope& p) { p.faces.pop_back(); });
  refused([](Polytope& p) { std::swap(p.faces[3][0], p.faces[3][1]); });
  refused([](Polytope& p) { p.faces[0][0] = 99; });
  refused([](Polytope& p) { p.faces[0] = {0, 4}; });
  refused([](Polytope& p) { p.faces.push_back(p.faces[0]); });
  refused([](Polytope& p) { p.vertices[0] = Vec3(0.5, 0.5, 0.5); });  // no longer convex
  refused([](Polytope& p) {
    for (auto& f : p.faces) std::swap(f[0], f[1]);  // inside out
  });
  refused([](Polytope& p) {
    for (Vec3& v : p.vertices) v.z() = 0;  // flat
  });
}

}  // namespace
}  // namespace touchstone::fast::lin_canny
