// Impulses of balls by the formulas of a textbook, and laws that all impacts obey.
#include "fast/simulation/impact.h"

#include <cmath>

#include "tests/catch.h"
#include "tests/fast/simulation/scenes.h"

namespace touchstone::fast::simulation {
namespace {

struct Two {
  Two(Body first, Body second)
      : body_a(std::move(first)), body_b(std::move(second)), a(body_a, 0, still), b(body_b, 0, still) {}
  ImpactResult impact(const Touch& touch, const Coefficients& c) const {
    return simulation::impact(a, a.state(0), b, b.state(0), touch, c);
  }
  Body body_a, body_b;
  BodyMotion a, b;
};

TEST_CASE("impact: the coefficients of a pair are the lesser of the bodies'") {
  const Two two(ball(1, still, still, {0.25, 2}), ball(1, {2, 0, 0}, still, {0.75, 1}));
  const Coefficients c = coefficients(two.a, two.b, Law::stronge);
  CHECK(c.restitution == 0.25);
  CHECK(c.friction == 1);
  CHECK(c.law == Law::stronge);
}

TEST_CASE("impact: equal balls exchange their velocities, unequal ones obey Newton's cradle") {
  const Touch touch{0, {1, 0, 0}, {-1, 0, 0}};
  const Two equal(ball(1, still, {3, 0, 0}, {}), ball(1, {2, 0, 0}, still, {}));
  const ImpactResult swapped = equal.impact(touch, {1, 0});
  CHECK(swapped.u_n == -3);
  CHECK(swapped.P_A_W == Vec3(-3, 0, 0));
  CHECK(swapped.after_a.v_WBcm == still);
  CHECK(swapped.after_b.v_WBcm == Vec3(3, 0, 0));
  CHECK(swapped.loss == 0);
  // Masses 3 and 1, e = 0: both at 3 · 3/4, and the loss is ½ · 3/4 · 3².
  const Two unequal(ball(1, still, {3, 0, 0}, {}, 3), ball(1, {2, 0, 0}, still, {}));
  const ImpactResult plastic = unequal.impact(touch, {0, 0});
  CHECK(plastic.after_a.v_WBcm.x() == Approx(2.25));
  CHECK(plastic.after_b.v_WBcm.x() == Approx(2.25));
  CHECK(plastic.loss == Approx(3.375));
}

TEST_CASE("impact: a ball that slips over a floor gets spin, by friction or until it rolls") {
  const Touch touch{0, still, {0, 0, 1}};
  const Two two(ball(1, {0, 0, 1}, {7, 0, -1}, {}), table());
  // u_n = −1, e = 1: P_n = 2. With μ = 0.25 the slip of 7 m/s loses 0.5 (1 + 1/0.4) = 1.75.
  const ImpactResult slips = two.impact(touch, {1, 0.25});
  CHECK(slips.P_A_W.x() == Approx(-0.5));
  CHECK(slips.P_A_W.z() == Approx(2));
  CHECK(slips.after_a.v_WBcm.x() == Approx(6.5));
  CHECK(slips.after_a.v_WBcm.z() == Approx(1));
  CHECK(slips.after_a.w_WB.y() == Approx(1.25));
  // With μ = 10 it stops slipping: 7/(1 + 1/0.4) = 2 N s, and rolls at 5 m/s.
  const ImpactResult sticks = two.impact(touch, {1, 10});
  CHECK(sticks.after_a.v_WBcm.x() == Approx(5));
  CHECK(sticks.after_a.w_WB.y() == Approx(5));
  CHECK(sticks.after_b.v_WBcm == still);
}

TEST_CASE("impact: a box that lands on a corner turns as the rigid body formula says") {
  // A cube of 1 kg and half side 1 (I = 2/3): at its lower corner (1, 0, −1) of the middle section, along z:
  // K = 1 + 1/I = 2.5, so P = (1 + e) · 3/2.5.
  Body cube = brick({1, 1, 1}, {0, 0, 1}, {});
  cube.mass = MassProperties{1, still, 2.0 / 3 * Mat3::Identity()};
  cube.velocity.v_WBcm = {0, 0, -3};
  const Two two(cube, table());
  const ImpactResult result = two.impact({0, {1, 0, 0}, {0, 0, 1}}, {0.5, 0});
  CHECK(result.P_A_W.z() == Approx(1.8));
  CHECK(result.after_a.v_WBcm.z() == Approx(-1.2));
  CHECK(result.after_a.w_WB.y() == Approx(-1.8 / (2.0 / 3)));
  CHECK(result.loss == Approx(0.5 * (1 - 0.25) * 9 / 2.5));
}

TEST_CASE(
    "impact: a micro-collision separates the bodies at the given speed, and reverses a slip that friction holds") {
  const Touch touch{0, still, {0, 0, 1}};
  const Two held(ball(1, {0, 0, 1}, {0.01, 0, -1}, {}), table());
  const ImpactResult result = micro_collision(held.a, held.a.state(0), held.b, held.b.state(0), touch, {0, 0.5}, 1);
  CHECK(result.after_a.v_WBcm.z() == Approx(1));
  // The slip 0.01 becomes −0.01: v − r w at the lowest point.
  CHECK(result.after_a.v_WBcm.x() - result.after_a.w_WB.y() == Approx(-0.01));
  const Two rises(ball(1, {0, 0, 1}, still, {}), table());
  CHECK(micro_collision(rises.a, rises.a.state(0), rises.b, rises.b.state(0), touch, {0, 0.5}, 1).after_a.v_WBcm.z() ==
        Approx(1));
}

}  // namespace
}  // namespace touchstone::fast::simulation
