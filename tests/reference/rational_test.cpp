#include "reference/rational.h"

#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/catch.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::reference {
namespace {

using tests::Dice;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double greatest = std::numeric_limits<double>::max();
constexpr double least = std::numeric_limits<double>::denorm_min();

/// Any finite double, each exponent alike.
double any_double(Dice& dice) {
  double x = 0;
  do x = std::bit_cast<double>(dice.bits());
  while (!std::isfinite(x));
  return x;
}

TEST_CASE("rational: a double is read as its own value") {
  CHECK(Rational(0.1).text() == "3602879701896397/36028797018963968");
  CHECK(Rational(-0.0) == Rational(0.0));
  CHECK(Rational(-3.0).text() == "-3");
  CHECK(Rational(std::string("-6/8")).text() == "-3/4");
  Dice dice(1);
  for (int i = 0; i < 20000; ++i) {
    const double x = any_double(dice);
    REQUIRE(Rational(x).nearest() == x);
    REQUIRE(Rational(x).enclosure() == Interval{x, x});
    REQUIRE(Rational(x).sign() == (x > 0) - (x < 0));
  }
}

TEST_CASE("rational: what is not a finite fraction is refused") {
  CHECK_THROWS_AS(Rational(infinity), std::invalid_argument);
  CHECK_THROWS_AS(Rational(std::nan("")), std::invalid_argument);
  for (const char* text : {"", "1/0", "x", "1/", "1.5", "1/2/3"}) {
    CHECK_THROWS_AS(Rational(std::string(text)), std::invalid_argument);
  }
  CHECK_THROWS_AS(Rational(1) /= Rational(0), std::domain_error);
  CHECK_THROWS_AS(Rational(-1).sqrt_enclosure(), std::domain_error);
}

TEST_CASE("rational: small fractions agree with integers") {
  Dice dice(2);
  for (int i = 0; i < 5000; ++i) {
    const int a = dice.between(-99, 99), b = dice.between(1, 99), c = dice.between(-99, 99), d = dice.between(1, 99);
    const Rational p = Rational(a) / Rational(b);
    const Rational q = Rational(c) / Rational(d);
    REQUIRE(p + q == Rational(a * d + c * b) / Rational(b * d));
    REQUIRE(p - q == Rational(a * d - c * b) / Rational(b * d));
    REQUIRE(p * q == Rational(a * c) / Rational(b * d));
    REQUIRE((p <=> q) == (a * d <=> c * b));
    REQUIRE(-p == Rational(-a) / Rational(b));
    if (c != 0) REQUIRE(p / q * q == p);
  }
}

// The processor rounds +, −, ×, ÷ and √ of doubles to nearest even, denormals and overflow included: a second opinion.
TEST_CASE("rational: nearest() rounds as the processor does") {
  Dice dice(3);
  for (int i = 0; i < 50000; ++i) {
    const double a = any_double(dice);
    const double b = any_double(dice);
    REQUIRE((Rational(a) + Rational(b)).nearest() == a + b);
    REQUIRE((Rational(a) * Rational(b)).nearest() == a * b);
    if (b != 0) REQUIRE((Rational(a) / Rational(b)).nearest() == a / b);
  }
}

TEST_CASE("rational: nearest() at the ends of the range and at ties") {
  const Rational half = Rational(1) / Rational(2);
  CHECK((Rational(least) * half).nearest() == 0);                   // tie: 0 is even
  CHECK((Rational(least) * Rational(1.5)).nearest() == 2 * least);  // tie: 2 is even
  CHECK((Rational(least) * Rational(2.5)).nearest() == 2 * least);
  CHECK((Rational(-least) * Rational(0.75)).nearest() == -least);
  const Rational half_way_out = Rational(greatest) + Rational(0x1p969);  // half an ulp of the last binade is 2^970
  CHECK(half_way_out.nearest() == greatest);
  CHECK((half_way_out + Rational(0x1p969)).nearest() == infinity);  // tie: goes to 2^1024
  CHECK((-half_way_out - Rational(0x1p969)).nearest() == -infinity);
  for (const double x : {1.0, 0x1.fffffffffffffp0, 0x1p-1022, 0x1p500, -3.0}) {
    const double next = std::nextafter(x, infinity);
    const double even = (Rational(x) + Rational(next)).nearest() / 2;
    CHECK(((Rational(x) + Rational(next)) * half).nearest() == even);
    CHECK((std::bit_cast<std::uint64_t>(even) & 1U) == 0);
  }
}

TEST_CASE("rational: enclosures are the tightest") {
  Dice dice(4);
  for (int i = 0; i < 20000; ++i) {
    const double numerator = any_double(dice);
    const Rational q = Rational(numerator) / (Rational(1) + Rational(std::abs(any_double(dice))));
    const Interval e = q.enclosure();
    REQUIRE((e.lo == e.hi ? Rational(e.lo) == q : Rational(e.lo) < q && q < Rational(e.hi)));
    REQUIRE((e.lo == e.hi || std::nextafter(e.lo, infinity) == e.hi));
    REQUIRE((q.nearest() == e.lo || q.nearest() == e.hi));
  }
  const Rational beyond = Rational(greatest) * Rational(2);
  CHECK(beyond.enclosure() == Interval{greatest, infinity});
  CHECK((-beyond).enclosure() == Interval{-infinity, -greatest});
}

TEST_CASE("rational: square roots are enclosed by neighbours, squares exactly") {
  CHECK(Rational(0).sqrt_enclosure() == Interval{0, 0});
  Dice dice(5);
  for (int i = 0; i < 20000; ++i) {
    const double a = std::abs(any_double(dice));
    REQUIRE((Rational(a) * Rational(a)).sqrt_enclosure() == Interval{a, a});
    const Rational q = Rational(a) / Rational(dice.between(1, 9));
    const Interval e = q.sqrt_enclosure();
    REQUIRE(Rational(e.lo) * Rational(e.lo) <= q);
    REQUIRE(Rational(e.hi) * Rational(e.hi) >= q);
    REQUIRE((e.lo == e.hi || std::nextafter(e.lo, infinity) == e.hi));
    const Interval of_a = Rational(a).sqrt_enclosure();
    REQUIRE((std::sqrt(a) == of_a.lo || std::sqrt(a) == of_a.hi));
  }
  const Rational tiny = Rational(least) * Rational(least) / Rational(3);
  CHECK(tiny.sqrt_enclosure() == Interval{0, least});
  const Rational huge = Rational(greatest) * Rational(greatest) * Rational(2);
  CHECK(huge.sqrt_enclosure() == Interval{greatest, infinity});
  CHECK((huge * huge).sqrt_enclosure() == Interval{greatest, infinity});
}

TEST_CASE("rational: a copy is a value of its own") {
  Rational a(1);
  Rational b = a;
  b += a;
  CHECK(a == Rational(1));
  a = b;
  b = Rational(7);
  CHECK(a == Rational(2));
  a = std::move(b);
  CHECK(a == Rational(7));
}

}  // namespace
}  // namespace touchstone::reference
