// Exact numbers: against integers that fit, against algebraic laws, and beyond the range of doubles.
#include "fast/exact/dyadic.h"

#include <cmath>
#include <limits>

#include "fast/exact/vector.h"
#include "tests/catch.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::fast::exact {
namespace {

using tests::Dice;

bool same(const Dyadic& x, const Dyadic& y) { return (x - y).sign() == 0; }

double any_double(Dice& dice) {
  const double m = dice.around_zero();
  return std::ldexp(m, dice.between(-300, 300));
}

TEST_CASE("small integers add and multiply as they do") {
  for (int x = -40; x <= 40; ++x) {
    for (int y = -40; y <= 40; ++y) {
      CHECK(same(Dyadic(x) + Dyadic(y), Dyadic(x + y)));
      CHECK(same(Dyadic(x) - Dyadic(y), Dyadic(x - y)));
      CHECK(same(Dyadic(x) * Dyadic(y), Dyadic(x * y)));
    }
  }
}

TEST_CASE("a double goes in and comes out") {
  Dice dice(1);
  for (int i = 0; i < 2000; ++i) {
    const double x = any_double(dice);
    CHECK(Dyadic(x).approximate() == x);
    CHECK(Dyadic(x).sign() == (x > 0) - (x < 0));
  }
  for (const double x :
       {std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max(), 0x1p-1022, 0.0}) {
    CHECK(Dyadic(x).approximate() == x);
    CHECK(Dyadic(-x).approximate() == -x);
  }
}

TEST_CASE("sums and products of doubles of all sizes obey the laws of a ring") {
  Dice dice(2);
  for (int i = 0; i < 500; ++i) {
    const Dyadic x = any_double(dice);
    const Dyadic y = any_double(dice);
    const Dyadic z = any_double(dice);
    CHECK(same(x * (y + z), x * y + x * z));
    CHECK(same((x + y) + z, x + (y + z)));
    CHECK(same((x + y) * (x - y), x * x - y * y));
    CHECK(same((x + y) - x, y));
  }
}

TEST_CASE("a rounded sum or product is the nearest double to the exact one") {
  Dice dice(3);
  for (int i = 0; i < 2000; ++i) {
    const double x = any_double(dice);
    const double y = std::ldexp(dice.around_zero(), std::ilogb(x));
    const double sum = x + y;
    const Dyadic half_gap = std::ldexp(1.0, std::ilogb(sum) - 53);
    const Dyadic error = Dyadic(x) + Dyadic(y) - Dyadic(sum);
    CHECK((error - half_gap).sign() <= 0);
    CHECK((error + half_gap).sign() >= 0);
    const double product = x * y;
    if (std::abs(product) < 0x1p-900 || std::abs(product) > 0x1p1000) continue;
    const Dyadic product_error = Dyadic(x) * Dyadic(y) - Dyadic(product);
    const Dyadic product_half_gap = std::ldexp(1.0, std::ilogb(product) - 53);
    CHECK((product_error - product_half_gap).sign() <= 0);
    CHECK((product_error + product_half_gap).sign() >= 0);
  }
}

TEST_CASE("there is no range to leave") {
  Dyadic tiny = std::numeric_limits<double>::denorm_min();
  Dyadic huge = std::numeric_limits<double>::max();
  for (int i = 0; i < 4; ++i) {
    tiny = tiny * tiny;
    huge = huge * huge;
  }
  CHECK(tiny.sign() == 1);
  CHECK((huge + tiny - huge).sign() == 1);
  CHECK(tiny.scientific().exponent == -16 * 1074 + 1);
  CHECK(tiny.approximate() == 0);
  CHECK(huge.approximate() == std::numeric_limits<double>::infinity());
}

TEST_CASE("scientific cuts towards zero by less than 2^-52") {
  Dice dice(4);
  for (int i = 0; i < 500; ++i) {
    const Dyadic x = Dyadic(any_double(dice)) * any_double(dice) + any_double(dice);
    if (x.sign() == 0) continue;
    const Dyadic::Scientific s = x.scientific();
    CHECK(std::abs(s.m) >= 0.5);
    CHECK(std::abs(s.m) < 1);
    if (std::abs(s.exponent) > 900) continue;
    const Dyadic cut = std::ldexp(s.m, static_cast<int>(s.exponent));
    const Dyadic magnitude = x.sign() > 0 ? x : -x;
    const Dyadic cut_magnitude = x.sign() > 0 ? cut : -cut;
    CHECK((magnitude - cut_magnitude).sign() >= 0);
    CHECK((magnitude - cut_magnitude * Dyadic(1 + 0x1p-52)).sign() < 0);
  }
}

TEST_CASE("a vector's direction is cut to doubles, its unit scale is exact") {
  const Vector v{Dyadic(0x1p900) * Dyadic(0x1p900), Dyadic(-3) * Dyadic(0x1p900) * Dyadic(0x1p898), 0};
  CHECK(direction(v) == Vec3(0.5, -0.375, 0) * 1.0);
  const Vector w = at_unit_scale(v);
  CHECK(w.x.approximate() == 0.5);
  CHECK(cross(v, w).is_zero());
}

}  // namespace
}  // namespace touchstone::fast::exact
