// Planes, heights, growth and the test for the origin, of polytopes whose differences are read off.
#include "fast/penetration/inner_polytope.h"

#include <cmath>

#include "tests/catch.h"

namespace touchstone::fast::penetration {
namespace {

using lin_canny::Hull;
using lin_canny::PosedHull;
using lin_canny::VertexDifference;

/// Vertices of B, with A the origin: the differences are these vertices.
struct Vertices {
  explicit Vertices(std::vector<Vec3> vertices)
      : hull_A(Vec3(0, 0, 0)), hull_B(Hull::of_vertices(std::move(vertices))) {
    A.hull = &hull_A;
    B.hull = &hull_B;
  }
  VertexDifference operator[](int b) const { return {0, b, Vec3::Zero(), B.vertex(b)}; }

  Hull hull_A, hull_B;
  PosedHull A, B;
};

const std::vector<Vec3> around = {{1, 0, -1}, {-1, 1, -1}, {-1, -1, -1}, {0, 0, 2}, {3, 0, -1}};

TEST_CASE("a tetrahedron around the origin: its planes face away, whatever the order of its corners") {
  const Vertices some(around);
  for (const std::array<int, 4>& order : {std::array{0, 1, 2, 3}, {1, 0, 2, 3}, {3, 2, 0, 1}}) {
    InnerPolytope polytope;
    polytope.start(some.A, some.B, {some[order[0]], some[order[1]], some[order[2]], some[order[3]]});
    CHECK(polytope.encloses_origin());
    CHECK(polytope.least_height() > 0);
    const std::optional<int> nearest = polytope.nearest_face();
    REQUIRE(nearest);
    CHECK(polytope.plane(*nearest).height == Approx(polytope.least_height()));
    CHECK(polytope.plane(*nearest).n.norm() == Approx(1));
    polytope.set_final(*nearest);
    CHECK(polytope.nearest_face() != nearest);
  }
}

TEST_CASE("a farther vertex makes it larger, moved away it does not enclose the origin") {
  Vertices some(around);
  InnerPolytope polytope;
  polytope.start(some.A, some.B, {some[0], some[1], some[2], some[3]});
  int seen = 0;
  while (polytope.plane(seen).n.dot(around[4]) <= polytope.plane(seen).height) ++seen;
  CHECK(polytope.insert(some[4], seen, 0x1p-40));
  CHECK(polytope.corner_count() == 5);
  CHECK(polytope.encloses_origin());
  some.B.t = Vec3(9, 0, 0);
  polytope.move(some.A, some.B);
  CHECK_FALSE(polytope.encloses_origin());
  CHECK(polytope.least_height() < 0);
  some.B.t = Vec3::Zero();
  polytope.move(some.A, some.B);
  CHECK(polytope.encloses_origin());
}

}  // namespace
}  // namespace touchstone::fast::penetration
