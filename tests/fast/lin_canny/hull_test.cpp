// A hull's adjacency is consistent, its faces are maximal, and what is not a solid is refused.
#include "fast/lin_canny/hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

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

void check_neighbourhoods(const Hull& hull) {
  CHECK(hull.vertex_count() - hull.edge_count() + hull.face_count() == 2);
  for (int f = 0; f < hull.face_count(); ++f) {
    const Hull::Face& face = hull.face(f);
    CHECK(std::abs(face.normal.norm() - 1) <= 8 * u);
    for (int v = 0; v < hull.vertex_count(); ++v) {
      CHECK(face.normal.dot(hull.vertex(v)) <= face.height + 8 * u * hull.radius());
    }
    for (int i = face.first_corner; i < face.first_corner + face.corner_count; ++i) {
      const Hull::Edge& side = hull.edge(hull.side(i));
      CHECK((side.tail == hull.corner(i) || side.head == hull.corner(i)));
      CHECK((side.face[0] == f || side.face[1] == f));
      CHECK(std::abs(face.normal.dot(hull.vertex(hull.corner(i))) - face.height) <= 64 * u * hull.radius());
    }
  }
  for (int e = 0; e < hull.edge_count(); ++e) {
    const Hull::Edge& edge = hull.edge(e);
    CHECK(edge.tail != edge.head);
    CHECK(edge.face[0] != edge.face[1]);
    for (int i = 0; i < 2; ++i) {
      const Hull::Face& face = hull.face(edge.face[i]);
      for (int c = face.first_corner; c < face.first_corner + face.corner_count; ++c) {
        const double beyond = edge.out[i].dot(hull.vertex(hull.corner(c)) - hull.vertex(edge.tail));
        CHECK(beyond <= 64 * u * hull.radius() * edge.out[i].norm());
      }
    }
  }
  for (int v = 0; v < hull.vertex_count(); ++v) {
    CHECK(hull.spokes_end(v) - hull.spokes_begin(v) >= 3);
    for (const Hull::Spoke* s = hull.spokes_begin(v); s != hull.spokes_end(v); ++s) {
      CHECK((s->away - (hull.vertex(s->other) - hull.vertex(v)).normalized()).norm() <= 8 * u);
    }
  }
}

TEST_CASE("neighbourhoods of boxes, lattice solids and round ones hang together") {
  check_neighbourhoods(Hull(Box{Vec3(1, 2, 3)}));
  check_neighbourhoods(Hull(tests::lattice_prism(325, 8)));
  check_neighbourhoods(Hull(tests::lattice_sphere(14)));
  Dice dice(3);
  for (int i = 0; i < 10; ++i) check_neighbourhoods(Hull(tests::round_hull(dice, 30)));
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
  for (int v = 0; v < 8; ++v) CHECK(same.source(v) == v);
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
