// Which normal two parts take that touch edge to edge or corner to corner: that along which they came together.
#include "fast/simulation/island/approach_normal.h"

#include <array>
#include <cmath>

#include "tests/catch.h"
#include "tests/fast/contact/posed.h"

namespace touchstone::fast::simulation {
namespace {

using contact::cube;
using contact::eighth_turn;
using contact::Posed;

const Vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
const double half_diagonal = std::sqrt(2.0);

bool is_near(const std::optional<Vec3>& n, const Vec3& expected) {
  return n && (*n - expected.normalized()).norm() < 1e-9;
}

/// A cube on another one, both on an edge along y, shifted along it. N is the quarter circle between (±1, 0, 1).
struct EdgeOnEdge {
  explicit EdgeOnEdge(double gap = 0)
      : A(cube(), Vec3(0, 0.5, 2 * half_diagonal + gap), eighth_turn(y)), B(cube(), Vec3::Zero(), eighth_turn(y)) {}
  Posed A, B;
};

}  // namespace

TEST_CASE("approach normal: edge to edge, the direction of approach if it separates the two") {
  const EdgeOnEdge bars;
  CHECK(is_near(approach_normal(bars.A.part(), bars.B.part(), -3 * z), z));
  CHECK(is_near(approach_normal(bars.A.part(), bars.B.part(), Vec3(0.5, 0, -2)), Vec3(-0.5, 0, 2)));
  CHECK(is_near(approach_normal(bars.B.part(), bars.A.part(), 3 * z), -z));
}

TEST_CASE("approach normal: slip along the edges has no part in it") {
  const EdgeOnEdge bars;
  CHECK(is_near(approach_normal(bars.A.part(), bars.B.part(), Vec3(0, 5, -2)), z));
}

TEST_CASE("approach normal: a gap or an overlap by rounding changes nothing") {
  for (const double gap : {0x1p-40, -0x1p-40}) {
    const EdgeOnEdge bars(gap);
    CHECK(is_near(approach_normal(bars.A.part(), bars.B.part(), Vec3(0.5, 0, -2)), Vec3(-0.5, 0, 2)));
  }
}

TEST_CASE("approach normal: none along a normal along which the bodies do not approach") {
  const EdgeOnEdge bars;
  CHECK_FALSE(approach_normal(bars.A.part(), bars.B.part(), z));
  CHECK_FALSE(approach_normal(bars.A.part(), bars.B.part(), Vec3(3, 0, -1)));  // not along (1, 0, 1)
  CHECK_FALSE(approach_normal(bars.A.part(), bars.B.part(), y));
}

TEST_CASE("approach normal: at two corners it is found in a cone, and is the nearest of it to the approach") {
  // N is the octant of the corner (1, 1, 1) of B: both corners have it.
  const Posed A(cube(), 2 * Vec3::Ones()), B(cube(), Vec3::Zero());
  CHECK(is_near(approach_normal(A.part(), B.part(), Vec3(-1, -2, -3)), Vec3(1, 2, 3)));
  CHECK(is_near(approach_normal(A.part(), B.part(), Vec3(-1, -1, -4)), Vec3(1, 1, 4)));
  CHECK_FALSE(approach_normal(A.part(), B.part(), Vec3(1, -2, -3)));  // x separates them
}

TEST_CASE("approach normal: none where one normal separates the two, or one is a ball") {
  const Posed above(cube(), Vec3(0.5, 0.5, 2)), B(cube(), Vec3::Zero()),
      on_edge(cube(), (1 + half_diagonal) * z, eighth_turn(y));
  const Posed ball(Sphere{1}, 2 * z);
  CHECK_FALSE(approach_normal(above.part(), B.part(), -z));
  CHECK_FALSE(approach_normal(on_edge.part(), B.part(), -z));
  CHECK_FALSE(approach_normal(ball.part(), B.part(), -z));
}

}  // namespace touchstone::fast::simulation
