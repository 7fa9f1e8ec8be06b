// Projections onto the friction cone, by hand and by the conditions that define them.
#include "fast/contact/sparse/friction_cone.h"

#include <random>

#include "tests/catch.h"
#include "tests/fast/contact/axes.h"

namespace touchstone::fast::contact {
namespace {

bool is_near(const Vec3& a, const Vec3& b) { return (a - b).norm() < 1e-14; }

TEST_CASE("friction cone: what is inside stays, what pulls becomes 0, and the rest moves to the nearest edge") {
  CHECK(nearest_in_cone({0.75, 0, 1}, z, 0.75).P == Vec3(0.75, 0, 1));
  CHECK(nearest_in_cone({0.75, 0, -1}, z, 0.75).P == Vec3(0, 0, 0));
  CHECK(nearest_in_cone({0, 0, -1}, z, 0).P == Vec3(0, 0, 0));
  CHECK(nearest_in_cone({3, 4, 1}, z, 0).P == Vec3(0, 0, 1));
  // The edge along (3, 4)/5 with μ = 3/4 has the direction (9, 12, 20)/25, and the product with z is 19/5.
  CHECK(is_near(nearest_in_cone({3, 4, 1}, z, 0.75).P, 3.8 / 25 * Vec3(9, 12, 20)));
  CHECK(is_near(nearest_in_cone({3, 4, -1}, z, 0.75).P, 2.2 / 25 * Vec3(9, 12, 20)));
}

TEST_CASE("friction disc: the normal part does not depend on the tangential one") {
  CHECK(nearest_in_disc({0.25, 0, 1}, z, 0.5).P == Vec3(0.25, 0, 1));
  CHECK(is_near(nearest_in_disc({3, 4, 2}, z, 0.5).P, {0.6, 0.8, 2}));
  CHECK(nearest_in_disc({3, 4, -2}, z, 0.5).P == Vec3(0, 0, 0));
  CHECK(is_near(nearest_in_disc({3, 4, 2}, z, 0).P, {0, 0, 2}));
}

TEST_CASE("friction cone: derivatives are what small changes give") {
  std::mt19937 numbers(1);
  const auto number = [&] { return static_cast<double>(numbers()) / 0x1p31 - 1; };
  const auto vector = [&] {
    const double x = number(), y = number();
    return Vec3(x, y, number());
  };
  for (int k = 0; k < 200; ++k) {
    const Vec3 n = vector().normalized(), at = vector(), change = 0x1p-20 * vector();
    const double friction = 1 + number();
    for (const auto project : {nearest_in_cone, nearest_in_disc}) {
      const ConeImpulse here = project(at, n, friction);
      const Vec3 found = project(at + change, n, friction).P - project(at - change, n, friction).P;
      // Of second order in the change; the few points within reach of an edge of the cone are left out.
      const bool is_smooth = (project(at + change, n, friction).derivative - here.derivative).norm() < 1e-3;
      if (is_smooth) CHECK((found / 2 - here.derivative * change).norm() < 1e-9);
    }
  }
}

}  // namespace
}  // namespace touchstone::fast::contact
