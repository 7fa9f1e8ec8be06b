// Contact points of cubes, edges and balls on a plate, whose corners are known.
#include "fast/contact/manifold.h"

#include <algorithm>
#include <cmath>

#include "tests/catch.h"
#include "tests/fast/contact/axes.h"
#include "tests/fast/contact/posed.h"

namespace touchstone::fast::contact {
namespace {

using Kind = Feature::Kind;

constexpr double within = 0x1p-20;

/// Checks where the contact points are, on A, in W; their order is free.
void check_places(const Posed& A, const Posed& B, const std::vector<Vec3>& expected) {
  const std::vector<ContactPoint> points = contact_points(A.part(), B.part(), z, within);
  CHECK(points.size() == expected.size());
  for (const Vec3& place : expected) {
    INFO(place.transpose());
    CHECK(std::ranges::any_of(points, [&](const ContactPoint& point) {
      const Vec3 found = nearness(point.a, A.part().body, point.b, B.part().body, z).p_WC;
      return (found - place).norm() < within / 8;  // a point may be as far beside a face as within/16
    }));
  }
}

TEST_CASE("manifold: a cube on a plate stands on its four corners, points over the plate's plane") {
  const Posed A(cube(), 2 * z), B(plate(), Vec3::Zero());
  check_places(A, B, {{-1, -1, 1}, {-1, 1, 1}, {1, -1, 1}, {1, 1, 1}});
  for (const ContactPoint& point : contact_points(A.part(), B.part(), z, within)) {
    CHECK(point.a.kind == Kind::point);
    CHECK(point.a.at.z() == Approx(-1));
    CHECK(point.b.kind == Kind::plane);
    CHECK((point.b.along - z).norm() < 1e-15);
    CHECK(point.F_A_W == Vec3(0, 0, 0));
  }
}

// Whichever of the two is named first: a plane of the cube's would tip with it.
TEST_CASE("manifold: of two faces the one that the other's corners are on gives the planes") {
  const Posed A(plate(), Vec3(0, 0, 2)), B(cube(), Vec3::Zero());
  const std::vector<ContactPoint> points = contact_points(A.part(), B.part(), z, within);
  CHECK(points.size() == 4);
  for (const ContactPoint& point : points) {
    CHECK(point.a.kind == Kind::plane);
    CHECK((point.a.along + z).norm() < 1e-15);
    CHECK(point.b.kind == Kind::point);
  }
}

TEST_CASE("manifold: a cube over the plate's side stands on the common rectangle, beside it on nothing") {
  const Posed B(plate(), Vec3::Zero());
  check_places(Posed(cube(), Vec3(4, 0, 2)), B, {{3, -1, 1}, {3, 1, 1}, {4, -1, 1}, {4, 1, 1}});
  check_places(Posed(cube(), Vec3(4, 4, 2)), B, {{3, 3, 1}, {3, 4, 1}, {4, 3, 1}, {4, 4, 1}});
  check_places(Posed(cube(), Vec3(6, 0, 2)), B, {});
}

// The cube is tilted by 2⁻¹⁵ about the plate's side, x = 4. Its lowest edge hangs over that side, 2⁻¹⁵ below it.
TEST_CASE("manifold: a face that is nearly parallel to the plate and hangs over its side stands on the side") {
  const double t = 0x1p-15;
  const Posed B(plate(), Vec3::Zero());
  const Posed A(cube(), Vec3(4 + std::sin(t), 0, 1 + std::cos(t)), {1, 0, std::tan(t / 2), 0});
  check_places(A, B, {{4, -1, 1}, {4, 1, 1}});
}

TEST_CASE("manifold: the plane is A's if B has no face there") {
  const Posed A(plate(), (1 + std::sqrt(2.0)) * z),
      B(cube(), Vec3::Zero(), eighth_turn(x));  // B's upper edge is along x
  const std::vector<ContactPoint> points = contact_points(A.part(), B.part(), z, within);
  REQUIRE(points.size() == 2);
  CHECK(points[0].a.kind == Kind::plane);
  CHECK(points[0].b.kind == Kind::point);
}

TEST_CASE("manifold: an edge on a plate stands on its two ends, or on the end and where it leaves the plate") {
  const double height = 1 + std::sqrt(2.0);
  const Posed B(plate(), Vec3::Zero());
  check_places(Posed(cube(), height * z, eighth_turn(x)), B, {{-1, 0, 1}, {1, 0, 1}});
  check_places(Posed(cube(), Vec3(4, 0, height), eighth_turn(x)), B, {{3, 0, 1}, {4, 0, 1}});
}

TEST_CASE("manifold: two edges that cross touch in one point, two that are parallel along their common part") {
  const double height = 2 * std::sqrt(2.0);
  const Posed across(cube(), Vec3::Zero(), eighth_turn(y)), along(cube(), Vec3::Zero(), eighth_turn(x));
  const Posed A(cube(), Vec3(1, 0, height), eighth_turn(x));
  check_places(A, across, {{0, 0, std::sqrt(2.0)}});
  CHECK(contact_points(A.part(), across.part(), z, within).front().a.kind == Kind::line);
  check_places(A, along, {{0, 0, std::sqrt(2.0)}, {1, 0, std::sqrt(2.0)}});
}

TEST_CASE("manifold: parallel edges that have no part in common do not touch") {
  const Posed A(cube(), Vec3(3, 0, 2 * std::sqrt(2.0)), eighth_turn(x)), B(cube(), Vec3::Zero(), eighth_turn(x));
  check_places(A, B, {});
}

// A's edge, 2 long, is turned about the vertical by twice 2⁻¹²: its ends are 2⁻¹¹ beside B's. By twice 2⁻²² they are
// within 2⁻²⁰ of it.
TEST_CASE("manifold: two edges that are hardly parallel touch where they cross, unless their ends are near the other") {
  const double height = 2 * std::sqrt(2.0);
  const Posed B(cube(), Vec3::Zero(), eighth_turn(x));
  const auto above = [&](double half_turn) {  // the product of the turns about z and x
    const double tan = std::sqrt(2.0) - 1;
    return Quaternion{1, tan, half_turn * tan, half_turn};
  };
  const Posed crossing(cube(), Vec3(0, 0, height), above(0x1p-12)), alike(cube(), Vec3(0, 0, height), above(0x1p-22));
  check_places(crossing, B, {{0, 0, std::sqrt(2.0)}});
  const ContactPoint point = contact_points(crossing.part(), B.part(), z, within).front();
  CHECK(point.a.kind == Kind::line);
  CHECK(point.b.kind == Kind::line);
  const std::vector<ContactPoint> ends = contact_points(alike.part(), B.part(), z, within);
  CHECK(ends.size() == 2);
  for (const ContactPoint& end : ends) {
    const Vec3 found = nearness(end.a, alike.part().body, end.b, B.part().body, z).p_WC;
    CHECK((found.cwiseAbs() - Vec3(1, 0, std::sqrt(2.0))).norm() < within);
  }
}

// An edge of A along x, one of B along y from -1 to 1. First A's is at y = 1.25, then it begins at x = 0.25.
TEST_CASE("manifold: two edges of which one ends before it crosses the other do not touch") {
  const Posed B(cube(), Vec3::Zero(), eighth_turn(y));
  check_places(Posed(cube(), Vec3(0, 1.25, 2 * std::sqrt(2.0)), eighth_turn(x)), B, {});
  check_places(Posed(cube(), Vec3(1.25, 0, 2 * std::sqrt(2.0)), eighth_turn(x)), B, {});
}

TEST_CASE("manifold: a corner touches a corner or an edge where the corner is") {
  const Polytope octahedron{{x, -x, y, -y, z, -z},
                            {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  const Posed below(octahedron, Vec3(0.25, 0, 0)), on_corner(octahedron, Vec3(0.25, 0, 2));
  check_places(on_corner, below, {{0.25, 0, 1}});
  const double height = std::sqrt(2.0);
  const Posed edge_below(cube(), Vec3::Zero(), eighth_turn(x)), on_edge(octahedron, Vec3(0.5, 0, height + 1));
  check_places(on_edge, edge_below, {{0.5, 0, height}});
  const Posed edge_above(cube(), Vec3(0, 0, height + 1), eighth_turn(x));
  check_places(edge_above, below, {{0.25, 0, 1}});
}

// Where rounding tilts n, the lowest corner of A is beside the corner or the edge of B: the two do not touch there.
TEST_CASE("manifold: a corner beside a corner or an edge does not touch it") {
  const Polytope octahedron{{x, -x, y, -y, z, -z},
                            {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  const Posed corner(octahedron, Vec3(0.25, 0, 0)), edge(cube(), Vec3::Zero(), eighth_turn(x));
  const double height = std::sqrt(2.0);
  for (const double off : {within / 2, 0.125}) {
    CAPTURE(off);
    const auto places = [off](const Vec3& at) { return off < within ? std::vector<Vec3>{at} : std::vector<Vec3>{}; };
    check_places(Posed(octahedron, Vec3(0.25 + off, 0, 2)), corner, places({0.25 + off, 0, 1}));
    check_places(Posed(octahedron, Vec3(0.5, off, height + 1)), edge, places({0.5, off, height}));
    check_places(Posed(octahedron, Vec3(1 + off, 0, height + 1)), edge, places({1 + off, 0, height}));
    check_places(Posed(cube(), Vec3(0, off, height + 1), eighth_turn(x)), corner, places({0.25, 0, 1}));
  }
}

TEST_CASE("manifold: a ball touches with its centre as a point with a radius") {
  const Posed ball(Sphere{0.5}, Vec3(1, 2, 1.5)), B(plate(), Vec3::Zero());
  check_places(ball, B, {{1, 2, 1}});
  CHECK(contact_points(ball.part(), B.part(), z, within).front().a.radius == 0.5);
  const Posed edge(cube(), Vec3::Zero(), eighth_turn(x));
  const Posed above(Sphere{0.5}, Vec3(0.25, 0, std::sqrt(2.0) + 0.5));
  check_places(above, edge, {{0.25, 0, std::sqrt(2.0)}});
  CHECK(contact_points(above.part(), edge.part(), z, within).front().b.kind == Kind::line);
}

TEST_CASE("manifold: a ball beside the end of an edge does not touch it, although it touches the edge's line") {
  const Posed edge(cube(), Vec3::Zero(), eighth_turn(x));
  const double height = std::sqrt(2.0);
  check_places(Posed(Sphere{0.5}, Vec3(1 + within / 2, 0, height + 0.5)), edge, {{1 + within / 2, 0, height}});
  check_places(Posed(Sphere{0.5}, Vec3(1.125, 0, height + 0.5)), edge, {});
}

TEST_CASE("manifold: a contact point between two given points is A's point over B's plane") {
  const Posed A(cube(), 3 * z), B(cube(), Vec3::Zero());
  const ContactPoint point = contact_point_between(A.part(), {0.5, 0, 2}, B.part(), {0.25, 0, 1}, z);
  const Nearness near = nearness(point.a, A.part().body, point.b, B.part().body, z);
  CHECK(near.gap == 1);
  CHECK(near.p_WC == Vec3(0.5, 0, 2));
}

}  // namespace
}  // namespace touchstone::fast::contact
