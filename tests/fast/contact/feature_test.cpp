// Gap, normal and contact point of two features, by hand.
#include "fast/contact/feature.h"

#include <cmath>

#include "tests/catch.h"

namespace touchstone::fast::contact {
namespace {

using Kind = Feature::Kind;

const Vec3 none = Vec3::Zero(), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
const RigidTransform origin;

Feature point(const Vec3& at, double radius = 0) { return {Kind::point, at, none, radius}; }
Feature line(const Vec3& at, const Vec3& along) { return {Kind::line, at, along, 0}; }
Feature plane(const Vec3& at, const Vec3& outward) { return {Kind::plane, at, outward, 0}; }

TEST_CASE("feature: a body's points in the world, and back") {
  Mat3 quarter;  // x to y, y to −x
  quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const RigidTransform turned{{5, 0, 1}, quarter};
  CHECK(turned.out({2, 0, 0}) == Vec3(5, 2, 1));
  CHECK(turned.in({5, 2, 1}) == Vec3(2, 0, 0));
}

TEST_CASE("feature: a ball over a plane, from either side") {
  const Nearness over = nearness(point({3, 4, 2}, 0.5), origin, plane(none, z), origin, z);
  CHECK(over.gap == 1.5);
  CHECK(over.nhat_BA_W == z);
  CHECK(over.p_WC == Vec3(3, 4, 1.5));
  const Nearness under = nearness(plane(none, z), origin, point({3, 4, 2}, 0.5), origin, z);
  CHECK(under.gap == 1.5);
  CHECK(under.nhat_BA_W == -z);
  CHECK(under.p_WC == Vec3(3, 4, 0));  // on A, which is the plane
  CHECK(nearness(point({0, 0, -1}), origin, plane(none, z), origin, z).gap == -1);
}

TEST_CASE("feature: two edges that cross, with the sign that is asked for") {
  for (const double side : {1.0, -1.0}) {
    const Nearness near = nearness(line({-7, 2, 3}, x), origin, line({1, 9, 1}, y), origin, side * z);
    CHECK(near.gap == 2 * side);  // below zero: seen from the other side they overlap
    CHECK(near.nhat_BA_W == side * z);
    CHECK((near.p_WC - Vec3(1, 2, 3)).norm() < 1e-14);
  }
}

TEST_CASE("feature: two balls, and a ball beside an edge") {
  const Nearness balls = nearness(point({4, 0, 0}, 1), origin, point({0, 3, 0}, 0.5), origin, z);
  CHECK(balls.gap == Approx(3.5));
  CHECK((balls.nhat_BA_W - Vec3(0.8, -0.6, 0)).norm() < 1e-15);
  CHECK((balls.p_WC - Vec3(3.2, 0.6, 0)).norm() < 1e-15);
  const Nearness beside = nearness(line({5, 0, 0}, x), origin, point({1, 3, 4}, 1), origin, z);
  CHECK(beside.gap == Approx(4));
  CHECK((beside.p_WC - Vec3(1, 0, 0)).norm() < 1e-14);
  const Nearness same = nearness(point(none, 1), origin, point(none, 2), origin, y);
  CHECK(same.nhat_BA_W == y);  // no direction of its own
  CHECK(same.gap == -3);
}

TEST_CASE("feature: features move with their bodies") {
  const RigidTransform lifted{{0, 0, 4}, Mat3::Identity()};
  CHECK(nearness(point({0, 0, 1}), lifted, plane(none, z), origin, z).gap == 5);
  CHECK(nearness(point({0, 0, 1}), origin, plane(none, z), lifted, z).gap == -3);
}

}  // namespace
}  // namespace touchstone::fast::contact
