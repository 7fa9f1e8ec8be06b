// The centre of mass of bodies with a density against the exact reference, including thin, distant and tiny solids.
#include "fast/outward/centre_of_mass.h"

#include <cmath>

#include "fast/outward/outward.h"
#include "model/input_error.h"
#include "reference/mass.h"
#include "tests/catch.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::fast {
namespace {

using reference::Rational;
using tests::body;
using tests::Dice;

/// The reference encloses the centre within a few ulps; the computed one, ± its error, must overlap that enclosure.
void check_centre(const Body& b) {
  Scene scene;
  scene.bodies = {b};
  const reference::MassTruth truth = reference::mass(scene)[0].value();
  const outward::CentreOfMass c = outward::centre_of_mass(b).value();
  for (int axis = 0; axis < 3; ++axis) {
    const Interval& exact = truth.p_BBcm[static_cast<std::size_t>(axis)];
    const Rational p = Rational(c.p_BBcm[axis]) * Rational(outward::unit);
    const Rational error = Rational(c.error) * Rational(outward::unit);
    REQUIRE(p - error <= Rational(exact.hi));
    REQUIRE(Rational(exact.lo) <= p + error);
  }
  REQUIRE(c.least_mass <= truth.mass.hi);
  REQUIRE(c.least_mass >= truth.mass.lo * (1 - 0x1p-46));
}

Polytope hull(Dice& dice, double size, const Vec3& flat, const Vec3& at) {
  std::vector<Vec3> points;
  for (int i = 0; i < 14; ++i) points.push_back(size * (flat.cwiseProduct(dice.in_cube()) + at));
  return reference::convex_hull(points);
}

TEST_CASE("centre of mass: of a density, as the exact one within its error") {
  Dice dice(41);
  for (const double size : {1.0, 1e-6, 1e9, 0x1p-80, 0x1p80}) {
    for (int i = 0; i < 12; ++i) {
      Body b = body(hull(dice, size, {1, 1, 1}, Vec3::Zero()));
      b.mass = Density{0.5 + dice.unit()};
      check_centre(b);
      check_centre(body(hull(dice, size, {1, 1, 1e-7}, dice.in_cube())));
      check_centre(body(hull(dice, size, {1, 1e-3, 1}, 1e6 * dice.in_cube())));
      Compound parts;
      for (int k = 0; k < 4; ++k) {
        const Quaternion q{dice.around_zero(), dice.around_zero(), dice.around_zero(), dice.around_zero()};
        const Pose X{size * 3 * dice.in_cube(), q};
        if (k == 0) parts.parts.push_back({X, Sphere{size * 0.3}});
        if (k == 1) parts.parts.push_back({X, Box{size * Vec3(1, 0.2, 0.01)}});
        if (k >= 2) parts.parts.push_back({X, hull(dice, size, {1, 0.5, 1}, dice.in_cube())});
      }
      check_centre(body(parts));
    }
  }
}

TEST_CASE("centre of mass: fixed bodies have none, and faces are needed") {
  Body b = body(Box{{1, 2, 3}});
  CHECK(outward::centre_of_mass(b).value().p_BBcm == Vec3::Zero());
  b.mass = Fixed{};
  CHECK_FALSE(outward::centre_of_mass(b).has_value());
  CHECK_THROWS_AS(outward::centre_of_mass(body(Polytope{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}})),
                  InputError);
}

}  // namespace
}  // namespace touchstone::fast
