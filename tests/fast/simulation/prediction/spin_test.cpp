#include "fast/simulation/prediction/spin.h"

#include <cmath>

#include "tests/catch.h"

namespace touchstone::fast::simulation {
namespace {

double norm(const Quaternion& q) { return std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z); }

TEST_CASE("spin: quarter and half turns about the axes, after the rotation that was there") {
  const double quarter = std::acos(-1) / 2, half = std::sqrt(0.5);
  const Quaternion z = turned({}, {0, 0, quarter});
  CHECK(z.w == Approx(half));
  CHECK(z.z == Approx(half));
  CHECK(std::abs(z.x) + std::abs(z.y) < 1e-15);
  // First a quarter turn about z, then half a turn about x: (i)(1 + k)/√2 = (i − j)/√2.
  const Quaternion both = turned(z, {2 * quarter, 0, 0});
  CHECK(std::abs(both.w) + std::abs(both.z) < 1e-15);
  CHECK(both.x == Approx(half));
  CHECK(both.y == Approx(-half));
}

TEST_CASE("spin: the result is a unit quaternion, whatever the scale of the first") {
  for (const double scale : {1.0, 1e-200, 1e200}) {
    const Quaternion q = turned({scale, 2 * scale, -scale, 0}, {0.3, -0.2, 5});
    CHECK(std::abs(norm(q) - 1) < 1e-15);
  }
}

TEST_CASE("spin: no turn, or one beyond the resolution of doubles, leaves the orientation") {
  CHECK(turned({0.6, 0, 0.8, 0}, Vec3::Zero()) == Quaternion{0.6, 0, 0.8, 0});
  CHECK(turned({0.6, 0, 0.8, 0}, {0x1p51, 0, 0}) == Quaternion{0.6, 0, 0.8, 0});
}

}  // namespace
}  // namespace touchstone::fast::simulation
