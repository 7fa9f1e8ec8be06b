// Boxes of bodies that rotate from frame to frame: climbing finds what a scan of all vertices finds, from every start.
#include <array>
#include <memory>
#include <tuple>

#include "fast/bounds/climb.h"
#include "fast/bounds/fixed_cube.h"
#include "fast/bounds/tight_box.h"
#include "fast/lin_canny/rotation.h"
#include "fast/motion/quaternion.h"
#include "reference/bounds.h"
#include "reference/exact_pose.h"
#include "tests/catch.h"
#include "tests/fast/box_law.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::fast {
namespace {

using reference::Rational;
using reference::RationalVec3;
using tests::body;
using tests::Dice;
using tests::round_hull;

/// Many edges are level and many vertices tie.
Polytope lattice_hull(Dice& dice) {
  std::vector<Vec3> points = {{-2, -2, -2}, {2, 2, -2}, {2, -2, 2}, {-2, 2, 2}};
  for (int i = 0; i < 12; ++i) points.push_back(dice.lattice(3));
  return reference::convex_hull(points);
}

/// Edges so short that the rounded heights of their ends do not tell which is higher.
Polytope hull_with_tiny_edges(Dice& dice) {
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner = 100 * dice.in_cube();
    for (int k = 0; k < 3; ++k) points.push_back(corner + 0x1p-44 * dice.in_cube());
  }
  return reference::convex_hull(points);
}

Quaternion any_turn(Dice& dice) {
  if (dice.between(0, 2) == 0) return tests::integer_quaternion(dice);
  return {dice.around_zero(), dice.around_zero(), dice.around_zero(), dice.around_zero()};
}

const Rational& along(const RationalVec3& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

/// By the definition in fast/bounds/climb.h, exactly.
int scan(const Polytope& polytope, const Pose& X_WB, int axis, int sign) {
  const auto order = [&](const Vec3& v) {
    const Rational height = along(reference::in_world(X_WB, v), axis);
    return std::tuple(sign > 0 ? height : -height, v.x(), v.y(), v.z());
  };
  int best = 0;
  for (int i = 1; i < static_cast<int>(polytope.vertices.size()); ++i) {
    const auto& vertices = polytope.vertices;
    if (order(vertices[static_cast<std::size_t>(i)]) > order(vertices[static_cast<std::size_t>(best)])) best = i;
  }
  return best;
}

void check_climb(const Polytope& polytope, const Quaternion& q) {
  const Pose X_WB{Vec3::Zero(), q};
  const auto hull = std::make_shared<const lin_canny::Hull>(polytope);
  const Mat3 R = lin_canny::rotation(q);
  std::array<Vec3, 6> highest;
  for (int k = 0; k < 6; ++k) {
    highest[static_cast<std::size_t>(k)] =
        polytope.vertices[static_cast<std::size_t>(scan(polytope, X_WB, k % 3, k < 3 ? 1 : -1))];
  }
  for (int start = 0; start < static_cast<int>(polytope.vertices.size()); ++start) {
    Climb climb(hull, start);
    const Climb::Six& six = climb.climb({&X_WB, 1}, R);
    for (std::size_t k = 0; k < 6; ++k) REQUIRE(hull->vertex(six[k]) == highest[k]);
  }
}

TEST_CASE("climb: equals the scan over all vertices from every start") {
  Dice dice(21);
  for (int i = 0; i < 20; ++i) check_climb(round_hull(dice, 20), any_turn(dice));
  for (int i = 0; i < 20; ++i) check_climb(lattice_hull(dice), any_turn(dice));
  for (int i = 0; i < 20; ++i) check_climb(hull_with_tiny_edges(dice), any_turn(dice));
}

// With integers many corners are exactly at one height, and only the exact product of the two rotations shows it.
TEST_CASE("climb: a part of a compound turns by the exact product of both rotations") {
  Dice dice(25);
  for (int i = 0; i < 60; ++i) {
    const Polytope polytope = lattice_hull(dice);
    const Quaternion outer = tests::integer_quaternion(dice), inner = tests::integer_quaternion(dice);
    const std::array<Pose, 2> poses{Pose{Vec3::Zero(), outer}, Pose{Vec3::Zero(), inner}};
    const Pose both{Vec3::Zero(), motion::product(outer, inner)};
    const auto hull = std::make_shared<const lin_canny::Hull>(polytope);
    for (int start = 0; start < static_cast<int>(polytope.vertices.size()); ++start) {
      Climb climb(hull, start);
      const Climb::Six& six = climb.climb(poses, lin_canny::rotation(outer) * lin_canny::rotation(inner));
      for (int k = 0; k < 6; ++k) {
        const int highest = scan(polytope, both, k % 3, k < 3 ? 1 : -1);
        REQUIRE(hull->vertex(six[static_cast<std::size_t>(k)]) == polytope.vertices[static_cast<std::size_t>(highest)]);
      }
    }
  }
}

/// Checks that `box` contains the exact one and is at most `allowed` wider on each side.
void check_box(const Aabb& box, const Body& b, const Rational& allowed) {
  const reference::ExactBox exact = reference::box(b);
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t k = static_cast<std::size_t>(axis);
    REQUIRE(Rational(box.lo[axis]) <= exact.lo[k]);
    REQUIRE(exact.hi[k] <= Rational(box.hi[axis]));
    REQUIRE(exact.lo[k] - Rational(box.lo[axis]) <= allowed);
    REQUIRE(Rational(box.hi[axis]) - exact.hi[k] <= allowed);
  }
}

Compound two_hulls(Dice& dice) {
  Compound compound;
  compound.parts.push_back({{dice.in_cube(), any_turn(dice)}, round_hull(dice, 12)});
  compound.parts.push_back({{dice.in_cube(), any_turn(dice)}, lattice_hull(dice)});
  compound.parts.push_back({{dice.in_cube(), any_turn(dice)}, Sphere{0.5}});
  return compound;
}

TEST_CASE("tight box: along a tumble it holds the exact box and obeys the law of bounds") {
  Dice dice(22);
  for (int i = 0; i < 12; ++i) {
    const std::array<Shape, 4> shapes = {round_hull(dice, 30), lattice_hull(dice), two_hulls(dice), Box{{1, 2, 3}}};
    for (const Shape& shape : shapes) {
      TightBox tight(shape);
      Body b = body(shape, 5 * dice.in_cube(), any_turn(dice));
      for (int frame = 0; frame < 12; ++frame) {
        b.X_WB.p_WB += 0.1 * dice.in_cube();
        b.X_WB.q_WB.w += 0.1;
        b.X_WB.q_WB.x -= 0.07;
        check_box(tight.at(b.X_WB), b, tests::widening(b));
      }
    }
  }
}

TEST_CASE("tight box: only polytopes climb") {
  CHECK_FALSE(TightBox(Sphere{1}).climbs());
  CHECK_FALSE(TightBox(Box{{1, 2, 3}}).climbs());
  Dice dice(23);
  CHECK(TightBox(round_hull(dice, 8)).climbs());
}

TEST_CASE("fixed cube: one size, holds the body at every orientation, and is no wider than its ball") {
  Dice dice(24);
  for (int i = 0; i < 20; ++i) {
    const std::array<Shape, 4> shapes = {round_hull(dice, 30), lattice_hull(dice), two_hulls(dice), Sphere{2}};
    for (const Shape& shape : shapes) {
      const FixedCube cube(shape);
      const Aabb first = cube.at({});
      const double side = (first.hi - first.lo).maxCoeff();
      for (int turn = 0; turn < 10; ++turn) {
        const Body b = body(shape, dice.in_cube(), any_turn(dice));
        const Aabb box = cube.at(b.X_WB);
        check_box(box, b, Rational(side));
        REQUIRE((box.hi - box.lo).maxCoeff() <= side * (1 + 0x1p-40));
        REQUIRE((box.hi - box.lo).minCoeff() >= side * (1 - 0x1p-40));
      }
    }
  }
  // A unit cube's ball has the radius √3 about its middle, wherever the body's origin is.
  Polytope corner =
      reference::convex_hull({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {2, 2, 0}, {2, 0, 2}, {0, 2, 2}, {2, 2, 2}});
  const Aabb box = FixedCube(corner).at({});
  for (int axis = 0; axis < 3; ++axis) CHECK(box.hi[axis] == Approx(1 + std::sqrt(3.0)));
}

}  // namespace
}  // namespace touchstone::fast
