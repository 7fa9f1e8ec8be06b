#include "reference/impulse.h"

#include "model/input_error.h"
#include "tests/catch.h"
#include "tests/reference/impacts.h"

namespace touchstone::reference {
namespace {

using tests::Blow;
using tests::diagonal;

Rational fraction(const char* text) { return Rational(std::string(text)); }

Rational dot(const ExactVec3& a, const ExactVec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

ExactVec3 times(const std::array<ExactVec3, 3>& K, const ExactVec3& P) {
  return {dot(K[0], P), dot(K[1], P), dot(K[2], P)};
}

ExactVec3 plus(const ExactVec3& a, const ExactVec3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

ExactVec3 u_after(const ImpulseTruth& t) { return plus(t.u0_W, times(t.K_W, t.P_A_W)); }

/// ΔT = P·(u0 + u_f)/2.
Rational energy_change(const ImpulseTruth& t) { return dot(t.P_A_W, plus(t.u0_W, u_after(t))) / Rational(2); }

TEST_CASE("impulse: Newton's law creates energy where slip stops, Poisson's and Stronge's do not") {
  const ImpulseTruth newton = impulse(tests::newton_paradox(Law::newton));
  const ImpulseTruth poisson = impulse(tests::newton_paradox(Law::poisson));
  const ImpulseTruth stronge = impulse(tests::newton_paradox(Law::stronge));
  CHECK(newton.K_W[0] == ExactVec3{fraction("5/2"), Rational(0), fraction("-3/2")});
  CHECK(newton.u0_W == ExactVec3{Rational(3), Rational(0), Rational(-5)});
  CHECK(newton.certified);
  CHECK(newton.error == 0);
  CHECK(newton.p_c == Rational(2));
  CHECK(newton.p_f == fraction("41/8"));
  CHECK(energy_change(newton) == Rational(25) * fraction("9/80"));
  CHECK(poisson.p_f == Rational(4));
  CHECK(u_after(poisson)[2] == Rational(5) * fraction("16/25"));
  CHECK(energy_change(poisson) == Rational(25) * fraction("-9/125"));
  // W_r = 25·31/200 = u_z²/(2·8/5): a root, so only near.
  CHECK_FALSE(stronge.certified);
  CHECK(std::abs((energy_change(stronge) - Rational(25) * fraction("-9/200")).nearest()) < 1e-45);
  for (const ImpulseTruth* t : {&newton, &poisson, &stronge}) {
    CHECK(t->modes.straight);
    CHECK(t->modes.slip_stops_in_compression);
    CHECK(t->modes.sticks);
    CHECK_FALSE(t->ambiguous);
  }
}

TEST_CASE("impulse: Painlevé: friction presses harder until slip stops") {
  const ImpulseTruth t = impulse(tests::painleve(-100, -1));
  CHECK(t.certified);
  CHECK(t.modes.painleve);
  CHECK(t.p_f == fraction("1851/40"));
  CHECK(u_after(t) == ExactVec3{Rational(0), Rational(0), fraction("617/34")});
  CHECK_FALSE(t.ambiguous);
}

TEST_CASE("impulse: Painlevé: an approach of next to nothing, a finite impulse, and none at all beside it") {
  const ImpulseTruth t = impulse(tests::painleve(-1, -0x1p-1074));
  REQUIRE(t.ambiguous);
  CHECK(*t.ambiguous < 1e-300);
  CHECK(std::abs((t.p_f - fraction("9/20")).nearest()) < 1e-300);
  CHECK(std::abs((u_after(t)[2] - fraction("3/17")).nearest()) < 1e-300);
  CHECK(std::abs((energy_change(t) - fraction("-127/680")).nearest()) < 1e-300);
  const ImpulseTruth grazing = impulse(tests::painleve(-1, 0));
  CHECK(grazing.modes.separating);
  CHECK(grazing.P_A_W == ExactVec3{});
  REQUIRE(grazing.ambiguous);
  CHECK(*grazing.ambiguous == 0);
}

TEST_CASE("impulse: without a contact there is no question") {
  Scene scene = tests::scene(Blow{});
  scene.contact.reset();
  CHECK_THROWS_AS(impulse(scene), InputError);
}

}  // namespace
}  // namespace touchstone::reference
