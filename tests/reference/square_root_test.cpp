// Comparisons of roots decide which of two parts is nearer: where they err, verdicts of compounds do, and no
// certificate shows it.
#include "reference/exact/square_root.h"

#include <cmath>
#include <limits>

#include "reference/exact/rational.h"
#include "tests/catch.h"

namespace touchstone::reference {
namespace {

Rational part(int numerator, int denominator) { return Rational(numerator) / Rational(denominator); }

TEST_CASE("square roots: of squares, the comparison is that of the numbers") {
  for (int a = 0; a <= 6; ++a) {
    for (int b = 0; b <= 6; ++b) {
      for (int c = -14; c <= 14; ++c) {
        CAPTURE(a, b, c);
        const Rational x = part(a, 3) * part(a, 3), y = part(b, 3) * part(b, 3);
        REQUIRE(compare_roots(x, y, part(c, 6)) == (Rational(2 * a - 2 * b - c)).sign());
      }
    }
  }
}

// √(n² + 1) = n + 1/(2n) − 1/(8n³) + 1/(16n⁵) − ..., and partial sums of the series are in turn too great and too
// small.
TEST_CASE("square roots: near ties of irrational roots are decided") {
  for (const double power : {1.0, 0x1p10, 0x1p100, 0x1p300}) {
    const Rational n(power), one(1), x = n * n + one, y = n * n;
    const Rational above = one / (Rational(2) * n), below = above - one / (Rational(8) * n * n * n);
    CAPTURE(power);
    CHECK(compare_roots(x, y, above) == -1);
    CHECK(compare_roots(x, y, below) == 1);
    CHECK(compare_roots(y, x, -above) == 1);
    CHECK(compare_roots(y, x, -below) == -1);
    CHECK(compare_roots(x, x, Rational(0)) == 0);
    CHECK(compare_roots(x, x, above) == -1);
    CHECK(compare_roots(x, Rational(0), n) == 1);
  }
  CHECK(compare_roots(Rational(8), Rational(2), Rational(0)) == 1);
  CHECK(compare_roots(Rational(2), Rational(8), Rational(0)) == -1);
}

TEST_CASE("square roots: bounds hold the root, and are as narrow as they say") {
  for (const Rational& x : {Rational(2), Rational(0.1), part(1, 3), Rational(0x1p-900) + Rational(0x1p-1000),
                            Rational(0x1p1000) + Rational(1), part(9, 4), Rational(0)}) {
    for (const long bits : {1L, 30L, 128L, 500L}) {
      CAPTURE(x.text(), bits);
      const RootBounds root = root_bounds(x.impl().value, bits);
      CHECK(root.lo * root.lo <= x.impl().value);
      CHECK(root.hi * root.hi >= x.impl().value);
      if (root.lo == root.hi) CHECK(root.lo * root.lo == x.impl().value);
      const mpq_class width = (root.hi - root.lo) * (mpz_class(1) << static_cast<mp_bitcnt_t>(bits));
      CHECK(width <= 2 * root.hi);
    }
  }
  CHECK(root_bounds(mpq_class(9, 4), 10).lo == mpq_class(3, 2));
  CHECK(root_bounds(mpq_class(9, 4), 10).hi == mpq_class(3, 2));
}

TEST_CASE("square roots: less a number, the enclosure is two neighbours, whatever cancels") {
  for (const double r : {0.0, 1.0, 0x1p40, 0x1p300}) {
    for (const double more : {0x1p-900, 0x1p-40, 2.0}) {
      CAPTURE(r, more);
      const Rational R(r), x = R * R + Rational(more);
      const Interval off = enclosure_of_root_minus(x, R), opposite = enclosure_of_minus_root(R, x);
      const Rational lo = Rational(off.lo) + R, hi = Rational(off.hi) + R;
      CHECK(off.lo >= 0);
      CHECK(lo * lo <= x);
      CHECK(hi * hi >= x);
      CHECK((off.lo == off.hi || std::nextafter(off.lo, std::numeric_limits<double>::infinity()) == off.hi));
      CHECK(opposite == Interval{-off.hi, -off.lo});
    }
  }
  CHECK(enclosure_of_root_minus(Rational(25), Rational(7)) == Interval{-2, -2});
}

}  // namespace
}  // namespace touchstone::reference
