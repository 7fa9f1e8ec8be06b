// Contact points with their gaps, for cubes and balls above a plate.
#include "fast/contact/gap_manifold.h"

#include <algorithm>
#include <cmath>

#include "tests/catch.h"
#include "tests/fast/contact/axes.h"
#include "tests/fast/contact/posed.h"

namespace touchstone::fast::contact {
namespace {

GapManifold manifold_of(const Posed& A, const Posed& B, const std::optional<Vec3>& before = {}) {
  return gap_manifold(A.part(), B.part(), proximity_of(A, B), before);
}

TEST_CASE("gap_manifold: a cube half a metre above a plate has its four corners, in the middle of the gap") {
  const Posed A(cube(), Vec3(3.5, 0, 2.5)), B(plate(), Vec3::Zero());
  const GapManifold found = manifold_of(A, B);
  CHECK((found.nhat_BA_W - z).norm() < 1e-15);
  REQUIRE(found.points.size() == 4);
  for (const GapPoint& point : found.points) {
    CHECK(point.gap == Approx(0.5));
    CHECK(point.p_WC.z() == Approx(1.25));
    CHECK(std::abs(point.p_WC.y()) == Approx(1));
    // The plate ends at x = 4.
    CHECK(std::min(std::abs(point.p_WC.x() - 2.5), std::abs(point.p_WC.x() - 4)) < 1e-14);
  }
}

TEST_CASE("gap_manifold: parts that overlap little keep the normal before, or else get that of the least overlap") {
  const Posed A(cube(), 1.875 * z), B(plate(), Vec3::Zero());
  for (const std::optional<Vec3>& before : {std::optional<Vec3>(z), std::optional<Vec3>()}) {
    const GapManifold found = manifold_of(A, B, before);
    CHECK((found.nhat_BA_W - z).norm() < 1e-15);
    REQUIRE(found.points.size() == 4);
    for (const GapPoint& point : found.points) {
      CHECK(point.gap == Approx(-0.125));
      CHECK(point.p_WC.z() == Approx(0.9375));
    }
  }
  const Vec3 tilted = Vec3(0.02, 0, 1).normalized();  // the overlap along it is 0.225
  CHECK((manifold_of(A, B, tilted).nhat_BA_W - tilted).norm() < 1e-15);
}

// Otherwise a block that tips over an edge has, along its first normal, the overlap of what is beyond the edge.
TEST_CASE("gap_manifold: parts that overlap by more than twice the least along the normal before get another") {
  const Posed A(cube(), 1.875 * z), B(plate(), Vec3::Zero());
  CHECK((manifold_of(A, B, Vec3(1, 0, 0)).nhat_BA_W - z).norm() < 1e-15);
  CHECK((manifold_of(A, B, Vec3(0.05, 0, 1).normalized()).nhat_BA_W - z).norm() < 1e-15);
}

// The box lies on the plate's upper face up to the rounding of its place: its nearest points say nothing about n.
TEST_CASE("gap_manifold: parts that are nearer than rounding get the normal of the least overlap") {
  const Quaternion tilt{5, 0, 1, 0};
  const Vec3 up(10.0 / 26, 0, 24.0 / 26);  // the tilt's z
  for (const double off : {0.0, 0x1p-53, 0x1p-51, 0x1p-47}) {
    for (const Vec3& far : {Vec3(0, 0, 0), Vec3(0x1p22, 0, 0)}) {
      const Vec3 centre = far + Vec3(0.9375 + off, 0, 2.25);
      const Posed A(Box{{0.8125, 0.40625, 0.40625}}, centre, tilt), B(Box{{3.25, 2, 2.03125}}, far, tilt);
      for (const std::optional<Vec3>& before : {std::optional<Vec3>(), std::optional<Vec3>(up)}) {
        const GapManifold found = manifold_of(A, B, before);
        CHECK((found.nhat_BA_W - up).norm() < 1e-15);
        CHECK(found.points.size() == 4);
      }
    }
  }
}

TEST_CASE("gap_manifold: a ball has one point, along the direction of its centre") {
  const Posed B(plate(), Vec3::Zero());
  const GapManifold above = manifold_of(Posed(Sphere{0.5}, Vec3(1, 2, 2)), B);
  REQUIRE(above.points.size() == 1);
  CHECK(above.nhat_BA_W == z);
  CHECK(above.points[0].gap == Approx(0.5));
  CHECK((above.points[0].p_WC - Vec3(1, 2, 1.25)).norm() < 1e-14);
  const GapManifold touching = manifold_of(Posed(Sphere{0.5}, Vec3(1, 2, 1.5)), B);
  REQUIRE(touching.points.size() == 1);
  CHECK(touching.points[0].gap == 0);
  const GapManifold beside = manifold_of(Posed(Sphere{0.5}, Vec3(7, 0, 5)), B);  // (3, 0, 4) from the plate's side
  CHECK((beside.nhat_BA_W - Vec3(0.6, 0, 0.8)).norm() < 1e-14);
  CHECK(beside.points[0].gap == Approx(4.5));
}

TEST_CASE(
    "gap_manifold: tilted by less than 25 degrees the faces still oppose each other, each corner has its own gap") {
  const double t = 0x1p-4;  // tan of half the angle: sine 32/257, cosine 255/257
  const Posed A(cube(), 3 * z, {1, 0, t, 0}), B(plate(), Vec3::Zero());
  const GapManifold found = manifold_of(A, B);
  REQUIRE(found.points.size() == 4);
  // The points are corners of B's face within A's, projected along the edge-to-face direction z.
  CHECK((found.nhat_BA_W - z).norm() < 1e-14);
  double least = 9, most = 0;
  for (const GapPoint& point : found.points) least = std::min(least, point.gap), most = std::max(most, point.gap);
  const double sine = 32.0 / 257, cosine = 255.0 / 257;
  CHECK(least == Approx(2 - cosine - sine));
  CHECK(most == Approx(2 - cosine + sine));
}

TEST_CASE("gap_manifold: tilted by 45 degrees, the pair of closest points is the only one") {
  const Posed A(cube(), 3 * z, eighth_turn({1, 0, 0})), B(plate(), Vec3::Zero());
  const GapManifold found = manifold_of(A, B);
  REQUIRE(found.points.size() == 1);
  CHECK(found.points[0].gap == Approx(2 - std::sqrt(2.0)));
}

}  // namespace
}  // namespace touchstone::fast::contact
