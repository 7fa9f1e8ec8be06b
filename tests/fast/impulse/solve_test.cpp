// The solver alone: impacts whose exact impulse is known, and the theorems that bound all others.
#include "fast/impulse/solve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fast/impulse/restart.h"
#include "properties/random.h"
#include "tests/catch.h"

namespace touchstone::fast::impulse {
namespace {

/// Relative velocity after the impact, and the change of kinetic energy.
struct After {
  double u1, u2, un, energy;
};

After after(const Impact& i, const Outcome& out) {
  const double v1 = i.l1 * out.P1 + i.k1 * out.p, v2 = i.l2 * out.P2 + i.k2 * out.p;
  const double vn = i.k1 * out.P1 + i.k2 * out.P2 + i.b * out.p;
  const double energy = out.P1 * (i.u1 + v1 / 2) + out.P2 * (i.u2 + v2 / 2) + out.p * (i.un + vn / 2);
  return {i.u1 + v1, i.u2 + v2, i.un + vn, energy};
}

// A uniform rod of mass 1 and half-length 1 at 45°, where Newton's law adds energy (docs/design/impulse.md).
Impact rod_at_45(Law law) { return {2.5, 1, -1.5, 0, 2.5, 0.6, 0, -1, law, 1, 1}; }

TEST_CASE("a rod at 45 degrees: Newton creates 9/80 J, Poisson loses 9/125, Stronge 9/200") {
  const Impact newton = rod_at_45(Law::newton), poisson = rod_at_45(Law::poisson), stronge = rod_at_45(Law::stronge);
  CHECK(after(newton, solve(newton)).energy == Approx(9.0 / 80).epsilon(1e-14));
  CHECK(after(poisson, solve(poisson)).energy == Approx(-9.0 / 125).epsilon(1e-14));
  CHECK(after(poisson, solve(poisson)).un == Approx(16.0 / 25).epsilon(1e-14));
  CHECK(solve(poisson).compression == Approx(2.0 / 5).epsilon(1e-14));
  CHECK(after(stronge, solve(stronge)).energy == Approx(-9.0 / 200).epsilon(1e-14));
  CHECK(after(stronge, solve(stronge)).un == Approx(std::sqrt(31 / 62.5)).epsilon(1e-14));
}

TEST_CASE("a rod that jams: sliding presses the bodies together until slip stops") {
  const Impact jam{3.4, 1, -1.2, 0, 1.6, -1, 0, -0.01, Law::poisson, 0.5, 2};
  const Outcome out = solve(jam);
  CHECK(out.p == Approx(1851.0 / 4000).epsilon(1e-14));
  CHECK(after(jam, out).un == Approx(617.0 / 3400).epsilon(1e-14));
  CHECK(after(jam, out).u1 == Approx(0).margin(1e-15));
}

TEST_CASE("a rough ball: friction stops slip, or does not, at 2/7 of it") {
  for (const double slip : {0.5, 3.0, 20.0}) {
    const Impact ball{3.5, 3.5, 0, 0, 1, 0.6 * slip, 0.8 * slip, -1, Law::poisson, 0.5, 0.4};
    const Outcome out = solve(ball);
    const double expected = std::min(0.4 * 1.5, slip / 3.5);
    CHECK(std::hypot(out.P1, out.P2) == Approx(expected).epsilon(1e-14));
    CHECK(out.P1 * 4 == Approx(out.P2 * 3).epsilon(1e-14));
    CHECK(out.p == 1.5);
    CHECK_FALSE(out.regime.curved);
  }
}

TEST_CASE("bodies that separate are left alone") {
  for (const double un : {0.0, 1.0, 1e-300}) {
    const Outcome out = solve({1, 1, 0, 0, 1, 1, 0, un, Law::poisson, 0.5, 0.5});
    CHECK_FALSE(out.regime.approached);
    CHECK(out.p == 0);
  }
}

// `miss` is relative to |u|, and 0/0 of bodies that may jam.
TEST_CASE("bodies without a relative velocity are near no discontinuity of the law") {
  for (const double k1 : {0.0, -1.2}) {
    const Outcome out = solve({3.4, 1, k1, 0, 1.6, 0, 0, 0, Law::poisson, 0.5, 2});
    CHECK_FALSE(out.regime.approached);
    CHECK(out.miss == Outcome().miss);
  }
}

TEST_CASE("friction without limit stops slip before anything else") {
  const Impact stuck{2, 4, 0.5, -1, 3, 1, -2, -5, Law::poisson, 0.25, std::numeric_limits<double>::infinity()};
  const After end = after(stuck, solve(stuck));
  CHECK(end.u1 == Approx(0).margin(1e-15));
  CHECK(end.u2 == Approx(0).margin(1e-15));
  CHECK(end.un == Approx(0.25 * (5 + 0.25 + 0.5)).epsilon(1e-14));  // −e (u_n − k·A⁻¹u_t)
}

TEST_CASE("after slip: on the rim of the disc the minimiser has a multiplier, inside none") {
  const Restart sticks = restart({2, 3, 0.5, 0.5, 1, 0, 0, -1, Law::poisson, 0, 1});
  CHECK(sticks.sticks);
  const Impact slick{2, 3, 1, -2, 4, 0, 0, -1, Law::poisson, 0, 0.25};
  const Restart slides = restart(slick);
  REQUIRE_FALSE(slides.sticks);
  CHECK(std::hypot(slides.line.t1, slides.line.t2) == Approx(0.25).epsilon(1e-15));
  const double along1 = slick.k1 + slick.l1 * slides.line.t1, along2 = slick.k2 + slick.l2 * slides.line.t2;
  CHECK(along1 * slides.d == Approx(along2 * slides.c).epsilon(1e-14));  // slip changes along itself
  CHECK(slides.line.g > 0);
}

double between(properties::Random& random, double lo, double hi) { return lo + (hi - lo) * random.unit(); }

/// Any positive definite K of condition up to some thousands.
Impact some_impact(properties::Random& random, Law law) {
  Impact i;
  i.l1 = std::exp2(between(random, -3, 3));
  i.l2 = std::exp2(between(random, -3, 3));
  i.b = std::exp2(between(random, -3, 3));
  const double angle = between(random, 0, 6.283), part = between(random, 0, 0.999);
  i.k1 = part * std::cos(angle) * std::sqrt(i.l1 * i.b);
  i.k2 = part * std::sin(angle) * std::sqrt(i.l2 * i.b);
  i.u1 = between(random, -1, 1);
  i.u2 = between(random, -1, 1);
  i.un = -between(random, 0, 1);
  i.e = between(random, 0, 1);
  i.mu = between(random, 0, 2);
  i.law = law;
  return i;
}

void any_impact(std::uint64_t seed, int count) {
  properties::Random random(seed);
  for (int k = 0; k < count; ++k) {
    const Impact i = some_impact(random, k % 2 == 0 ? Law::poisson : Law::stronge);
    const Outcome out = solve(i);
    const After end = after(i, out);
    CAPTURE(k, i.l1, i.l2, i.k1, i.k2, i.b, i.u1, i.u2, i.un, i.e, i.mu);
    const double scale = 4 + i.u1 * i.u1 / i.l1 + i.u2 * i.u2 / i.l2 + i.un * i.un / i.b;
    CHECK(out.p > 0);
    const double rounding = 0x1p-53 * (std::abs(i.u1) + std::abs(i.u2) + std::abs(i.un)) / std::min(i.l1, i.l2);
    CHECK(std::hypot(out.P1, out.P2) <= i.mu * out.p * (1 + 1e-14) + rounding);
    CHECK(end.un >= -1e-13 * scale);
    const double inverse_nn = 1 / (i.b - i.k1 * i.k1 / i.l1 - i.k2 * i.k2 / i.l2);
    const double least_loss = i.law == Law::poisson ? (1 - i.e) / (1 + i.e) * out.p * out.p / inverse_nn / 2 : 0;
    CHECK(end.energy <= -least_loss + 1e-13 * scale);
    if (i.law == Law::poisson && !out.regime.compressed_again) {
      CHECK(out.p == Approx((1 + i.e) * out.compression).epsilon(1e-15));
    }
  }
}

TEST_CASE("any impact: in the cone, no approach left, energy within the theorems") { any_impact(1, 20000); }

// Run by hand: touchstone_tests_fast "[.soak]"
TEST_CASE("ten million impacts: in the cone, no approach left, energy within the theorems", "[.soak]") {
  any_impact(2, 10'000'000);
}

TEST_CASE("a tiny slip turns, stops and sticks as a large one does") {
  for (const double slip : {1e-10, 1e-100, 1e-170, 1e-300}) {
    const Impact i{2, 3, 0.5, 0.25, 1, 0.6 * slip, 0.8 * slip, -1, Law::poisson, 0.5, 0.8};
    const After end = after(i, solve(i));
    CHECK(end.u1 == Approx(0).margin(1e-15));
    CHECK(end.u2 == Approx(0).margin(1e-15));
  }
}

TEST_CASE("speeds and masses of any size: only the unit changes") {
  const Impact one{2, 3, 0.5, 0.25, 1, 0.6, -0.8, -1, Law::poisson, 0.5, 0.3};
  const Outcome out = solve(one);
  for (const int power : {-900, -300, 300, 900}) {
    Impact far = one;
    for (double* x : {&far.u1, &far.u2, &far.un}) *x = std::ldexp(*x, power);
    const Outcome same = solve(far);
    CHECK(same.p == std::ldexp(out.p, power));
    CHECK(same.P1 == std::ldexp(out.P1, power));
  }
}

}  // namespace
}  // namespace touchstone::fast::impulse
