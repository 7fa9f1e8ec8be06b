// How far cubes and balls are apart along a normal, and which normal separates them.
#include "fast/contact/parting.h"

#include <algorithm>
#include <cmath>

#include "tests/catch.h"
#include "tests/fast/contact/axes.h"
#include "tests/fast/contact/posed.h"

namespace touchstone::fast::contact {
namespace {

bool is_near(const Vec3& a, const Vec3& b) { return (a - b).norm() < 1e-14; }

TEST_CASE("parting: two cubes, one 3 above the other, are 1 apart, overlap is negative") {
  const Posed A(cube(), 3 * z), B(cube(), Vec3::Zero()), low(cube(), 1.75 * z);
  CHECK(apart(A.part(), B.part(), z) == 1);
  CHECK(apart(low.part(), B.part(), z) == -0.25);
}

TEST_CASE("parting: a ball counts with its radius") {
  const Posed ball(Sphere{0.5}, 2 * z), B(cube(), Vec3::Zero());
  CHECK(apart(ball.part(), B.part(), z) == 0.5);
  CHECK(apart(B.part(), ball.part(), -z) == 0.5);
}

TEST_CASE("parting: clearances of all vertices, first A's and then B's") {
  const Posed A(cube(), 3 * z), B(cube(), Vec3::Zero());
  const std::vector<double> all = clearances(A.part(), B.part(), z);
  REQUIRE(all.size() == 16);
  CHECK(std::ranges::count(all, 1.0) == 8);  // four lower corners of A, four upper ones of B
  CHECK(std::ranges::count(all, 3.0) == 8);
  CHECK(std::count(all.begin(), all.begin() + 8, 1.0) == 4);
}

TEST_CASE("parting: faces within 25 degrees of a normal, B's first") {
  const Posed A(cube(), 3 * z), B(cube(), Vec3::Zero());
  const auto tilted = [](double angle) { return Vec3(std::sin(angle), 0, std::cos(angle)); };
  const std::vector<Vec3> near = faces_along(A.part(), B.part(), tilted(0.4));  // 23°
  REQUIRE(near.size() == 2);
  CHECK(is_near(near[0], z));
  CHECK(is_near(near[1], z));
  CHECK(faces_along(A.part(), B.part(), tilted(0.5)).empty());  // 29°
  const Posed ball(Sphere{0.5}, 3 * z);
  CHECK(faces_along(ball.part(), B.part(), z).size() == 1);
}

TEST_CASE("parting: the shortest connection of parts that are apart") {
  const Posed A(cube(), Vec3(3, 0, 4)), B(cube(), Vec3::Zero());  // from edge to edge by (1, 0, 2)
  CHECK(is_near(parting(A.part(), B.part(), proximity_of(A, B)), Vec3(1, 0, 2) / std::sqrt(5.0)));
  const Posed ball(Sphere{0.5}, Vec3(4, 0, 5));
  CHECK(is_near(parting(ball.part(), B.part(), proximity_of(ball, B)), Vec3(0.6, 0, 0.8)));
}

TEST_CASE("parting: parts that overlap are separated by the plane of least overlap") {
  const Posed A(cube(), Vec3(0.25, 0.5, 1.75)), B(cube(), Vec3::Zero());  // by 1.75, 1.5 and 0.25
  CHECK(is_near(parting(A.part(), B.part(), proximity_of(A, B)), z));
}

TEST_CASE("parting: two edges that cross and overlap are separated along their cross product") {
  const double height = 2 * std::sqrt(2.0) - 0.125;
  const Posed A(cube(), height * z, eighth_turn({1, 0, 0})), B(cube(), Vec3::Zero(), eighth_turn({0, 1, 0}));
  CHECK(is_near(parting(A.part(), B.part(), proximity_of(A, B)), z));
  CHECK(apart(A.part(), B.part(), z) == Approx(-0.125));
}

TEST_CASE("parting: a face's normal replaces a direction that is the same up to rounding") {
  const Posed A(cube(), Vec3(0.125, 0, 3)), B(plate(), Vec3::Zero());
  CHECK(parting(A.part(), B.part(), proximity_of(A, B)) == z);
}

}  // namespace
}  // namespace touchstone::fast::contact
