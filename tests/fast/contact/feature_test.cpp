// Gap, normal and contact point of two features at poses for which they are known.
#include "fast/contact/feature.h"

#include <cmath>

#include "fast/lin_canny/rotation.h"
#include "tests/catch.h"
#include "tests/fast/contact/axes.h"

namespace touchstone::fast::contact {
namespace {

using Kind = Feature::Kind;

const RigidTransform origin;

RigidTransform at(const Vec3& centre) { return {centre, Mat3::Identity()}; }
Feature point(double radius) { return {Kind::point, Vec3::Zero(), Vec3::Zero(), radius}; }
Feature plane(const Vec3& on, const Vec3& normal) { return {Kind::plane, on, normal, 0}; }
Feature line(const Vec3& along) { return {Kind::line, Vec3::Zero(), along, 0}; }

void check(const Nearness& near, double gap, const Vec3& n, const Vec3& p_WC) {
  CHECK(near.gap == Approx(gap).margin(1e-15));
  CHECK((near.nhat_BA_W - n).norm() < 1e-15);
  CHECK((near.p_WC - p_WC).norm() < 1e-15);
}

TEST_CASE("feature: a ball of radius 1/2 with its centre 2 above a plane has a gap of 3/2") {
  check(nearness(point(0.5), at({1, 2, 3}), plane(z, z), origin, z), 1.5, z, {1, 2, 2.5});
}

TEST_CASE("feature: the plane may be A's, then the normal is the opposite, and the contact point is on the plane") {
  check(nearness(plane(z, z), origin, point(0.5), at({1, 2, 3}), z), 1.5, -z, {1, 2, 1});
}

TEST_CASE("feature: the pose turns a plane and moves its point") {
  const RigidTransform turned{Vec3(0, 0, 5), lin_canny::rotation({1, 1, 0, 0})};  // y becomes z
  check(nearness(point(0), at({7, 7, 7}), plane(y, y), turned, z), 1, z, {7, 7, 7});
}

TEST_CASE("feature: two lines that cross at a height of 2, `about` decides on the sign") {
  check(nearness(line(x), at(2 * z), line(y), origin, z), 2, z, 2 * z);
  check(nearness(line(x), at(2 * z), line(y), origin, -z), -2, -z, 2 * z);
}

TEST_CASE("feature: skew lines at 60 degrees, through other points than the nearest ones") {
  const Vec3 e(0.5, std::sqrt(0.75), 0);
  // The nearest points are those above each other, at the origin; A's line is given by a point 3 along it.
  check(nearness(line(x), at({3, 0, 1}), line(e), at(2 * e), z), 1, z, z);
}

TEST_CASE("feature: a ball beside a line 5 away touches along the shortest connection, in either order") {
  const Vec3 n(0, 0.6, 0.8);
  check(nearness(point(1), at({9, 3, 4}), line(x), origin, z), 4, n, Vec3(9, 3, 4) - n);
  check(nearness(line(x), origin, point(1), at({9, 3, 4}), z), 4, -n, {9, 0, 0});
}

TEST_CASE("feature: two balls that overlap by 1, without a connection the normal is `about`") {
  check(nearness(point(2), at(4 * x), point(3), origin, z), -1, x, 2 * x);
  check(nearness(point(2), origin, point(3), origin, y), -5, y, -2 * y);
}

TEST_CASE("feature: a rigid transform and its inverse") {
  const RigidTransform X{Vec3(1, 2, 3), lin_canny::rotation({1, 0, 0, 1})};  // x becomes y
  CHECK((X.out(x) - Vec3(1, 3, 3)).norm() < 1e-15);
  CHECK((X.in(X.out({4, 5, 6})) - Vec3(4, 5, 6)).norm() < 1e-15);
}

}  // namespace
}  // namespace touchstone::fast::contact
