// Boxes over a frame of ballistic motion: no exact position of the body is outside, and the sides are at the parabola's
// extremes.
#include "fast/bounds/ballistic_box.h"

#include <array>
#include <cmath>

#include "fast/bounds/forced_box.h"
#include "fast/outward/displacement.h"
#include "model/input_error.h"
#include "reference/bounds.h"
#include "reference/exact_pose.h"
#include "tests/catch.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::fast {
namespace {

using reference::Rational;
using reference::RationalVec3;
using tests::body;
using tests::Dice;
using Exact3 = std::array<Rational, 3>;

Exact3 exact(const RationalVec3& p) { return {p.x, p.y, p.z}; }

Quaternion any_turn(Dice& dice) {
  return {dice.around_zero(), dice.around_zero(), dice.around_zero(), dice.around_zero()};
}

/// A hull with a given centre of mass, away from its middle, so that the centre is exact.
Body any_body(Dice& dice) {
  std::vector<Vec3> points;
  for (int i = 0; i < 12; ++i) points.push_back(dice.in_cube());
  Body b = body(reference::convex_hull(points), 10 * dice.in_cube(), any_turn(dice));
  b.mass = MassProperties{2, 0.3 * dice.in_cube(), Mat3::Identity()};
  b.velocity = {5 * dice.in_cube(), dice.in_cube()};
  return b;
}

/// c + v t + a t²/2, an axis.
Rational ballistic_state(const Body& b, int axis, const Rational& a, const Rational& t) {
  const std::size_t k = static_cast<std::size_t>(axis);
  const Rational c = exact(reference::in_world(b.X_WB, std::get<MassProperties>(b.mass).p_BBcm))[k];
  return c + Rational(b.velocity.v_WBcm[axis]) * t + a * t * t / Rational(2);
}

/// Checks every vertex, rotated about the centre of mass by q, with that centre at c.
void check_inside(const Aabb& box, const Body& b, const Exact3& c, const Quaternion& q) {
  const Pose turn{Vec3::Zero(), q};
  const Exact3 own = exact(reference::in_world(turn, std::get<MassProperties>(b.mass).p_BBcm));
  for (const Vec3& v : std::get<Polytope>(b.shape).vertices) {
    const Exact3 p = exact(reference::in_world(turn, v));
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t k = static_cast<std::size_t>(axis);
      const Rational at = c[k] + p[k] - own[k];
      REQUIRE(Rational(box.lo[axis]) <= at);
      REQUIRE(at <= Rational(box.hi[axis]));
    }
  }
}

TEST_CASE("ballistic box: holds the body at every moment, however it has turned by then") {
  Dice dice(31);
  for (int i = 0; i < 60; ++i) {
    const Body b = any_body(dice);
    const Vec3 g = 10 * dice.in_cube();
    const double T = std::ldexp(dice.unit(), dice.between(-8, 3));
    const Aabb box = ballistic_box(b, g, T);
    for (int k = 0; k <= 8; ++k) {
      // Includes the times at which an axis' parabola has its apex.
      const int axis = k % 3;
      const double apex = -b.velocity.v_WBcm[axis] / g[axis];
      const double t = k < 6 ? T * k / 5 : apex > 0 && apex < T ? apex : T;
      Exact3 c;
      for (int j = 0; j < 3; ++j) c[static_cast<std::size_t>(j)] = ballistic_state(b, j, Rational(g[j]), Rational(t));
      check_inside(box, b, c, any_turn(dice));
      check_inside(box, b, c, b.X_WB.q_WB);
    }
  }
}

TEST_CASE("ballistic box: a body that does not turn has its tight box, stretched by the exact parabola") {
  Dice dice(32);
  for (int i = 0; i < 100; ++i) {
    Body b = any_body(dice);
    b.velocity.w_WB.setZero();
    const Vec3 g = 10 * dice.in_cube();
    const double T = dice.unit();
    const Aabb box = ballistic_box(b, g, T);
    const reference::ExactBox still = reference::box(b);
    // 128 u times a size of at most 3‖c‖₁ + ... < 200 m, as fast/bounds/ballistic_box.h says.
    const Rational allowed(128 * 0x1p-53 * 200);
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t k = static_cast<std::size_t>(axis);
      const Rational v(b.velocity.v_WBcm[axis]), a(g[axis]),
          end = v * Rational(T) + a * Rational(T) * Rational(T) / Rational(2);
      Rational lo = std::min(Rational(0.0), end), hi = std::max(Rational(0.0), end);
      const Rational apex_time = -v / a;
      if (apex_time.sign() > 0 && apex_time < Rational(T)) {
        const Rational apex = -v * v / (Rational(2) * a);
        lo = std::min(lo, apex);
        hi = std::max(hi, apex);
      }
      CHECK(Rational(box.lo[axis]) <= still.lo[k] + lo);
      CHECK(still.hi[k] + hi <= Rational(box.hi[axis]));
      CHECK(still.lo[k] + lo - Rational(box.lo[axis]) <= allowed);
      CHECK(Rational(box.hi[axis]) - still.hi[k] - hi <= allowed);
    }
  }
}

TEST_CASE("ballistic box: a ball thrown up by hand") {
  // v = 10, g = -10: the apex is 5 m up after 1 s, and after 2 s the ball is back.
  Body ball = body(Sphere{1});
  ball.velocity.v_WBcm = {1, 0, 10};
  const Aabb box = ballistic_box(ball, {0, 0, -10}, 2);
  CHECK(box.hi.z() == Approx(6));
  CHECK(box.lo.z() == Approx(-1));
  CHECK(box.lo.x() == Approx(-1));
  CHECK(box.hi.x() == Approx(3));
  ball.mass = Fixed{};
  CHECK(ballistic_box(ball, {0, 0, -10}, 2).hi.z() == Approx(1));
}

TEST_CASE("forced box: holds the body under every constant force within the bound, and is reached by the greatest") {
  Dice dice(33);
  for (int i = 0; i < 60; ++i) {
    const Body b = any_body(dice);
    const Vec3 g = 10 * dice.in_cube();
    const double T = dice.unit(), force = 20 * dice.unit();
    const Aabb box = forced_box(b, g, T, force);
    for (int k = 0; k < 6; ++k) {
      for (const double part : {0.5, 1.0}) {
        Exact3 c;
        for (int j = 0; j < 3; ++j) {
          const Rational pushed = j == k % 3 ? Rational(k < 3 ? force : -force) / Rational(2.0) : Rational(0.0);
          c[static_cast<std::size_t>(j)] = ballistic_state(b, j, Rational(g[j]) + pushed, Rational(part * T));
        }
        check_inside(box, b, c, any_turn(dice));
      }
    }
  }
  // A ball of 2 kg at rest under a force of 4 N for 1 s: 1 m in any direction.
  Body ball = body(Sphere{1});
  ball.mass = MassProperties{2, Vec3::Zero(), Mat3::Identity()};
  const Aabb box = forced_box(ball, Vec3::Zero(), 1, 4);
  for (int axis = 0; axis < 3; ++axis) {
    CHECK(box.hi[axis] == Approx(2));
    CHECK(box.lo[axis] == Approx(-2));
  }
}

TEST_CASE("boxes over a frame: no force changes nothing, no time is no flight, bad numbers are refused") {
  Dice dice(34);
  const Body b = any_body(dice);
  const Vec3 g(0, 0, -10);
  const Aabb free = ballistic_box(b, g, 0.5), forced = forced_box(b, g, 0.5, 0);
  CHECK((free.lo - forced.lo).cwiseAbs().maxCoeff() < 1e-13);
  CHECK((free.hi - forced.hi).cwiseAbs().maxCoeff() < 1e-13);
  for (const double bad : {-1.0, std::nan(""), static_cast<double>(INFINITY)}) {
    CHECK_THROWS_AS(ballistic_box(b, g, bad), InputError);
    CHECK_THROWS_AS(forced_box(b, g, bad, 1), InputError);
    CHECK_THROWS_AS(forced_box(b, g, 1, bad), InputError);
  }
}

TEST_CASE("boxes over a frame: at the end of the range the greatest finite double stands") {
  Body ball = body(Sphere{1});
  ball.velocity.v_WBcm = {1e308, -1e308, 0};
  const Aabb box = ballistic_box(ball, {1e308, 0, -1e308}, 1e10);
  CHECK(box.lo.allFinite());
  CHECK(box.hi.allFinite());
  CHECK(box.hi.x() == std::numeric_limits<double>::max());
}

}  // namespace
}  // namespace touchstone::fast
