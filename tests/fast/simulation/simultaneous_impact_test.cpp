// Impacts at several contact points at one time: outcomes as computed on paper, and what must not change them.
#include "fast/simulation/simultaneous_impact.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fast/lin_canny/rotation.h"
#include "reference/validity.h"
#include "tests/catch.h"
#include "tests/fast/simulation/scenes.h"

namespace touchstone::fast::simulation {
namespace {

const Vec3 none = Vec3::Zero();

Body fixed(Body body) {
  body.mass = Fixed{};
  return body;
}

/// A box of these half extents, `height` above z = 0.
Body falling(const Vec3& half, double height, const Vec3& v, const Material& material) {
  Body body = brick(half, Vec3(0, 0, half.z() + height), material);
  body.velocity.v_WBcm = v;
  return body;
}

Velocity velocity_after(const std::vector<Body>& bodies, std::size_t id = 0, double end = 2) {
  const Simulated done = simulate(moving_scene(bodies, none, {end}));
  REQUIRE(!done.stopped);
  return done.trajectory.states.back()[id].velocity;
}

bool is_near(const Velocity& V, const Vec3& v, const Vec3& w = none, double most = 1e-12) {
  return (V.v_WBcm - v).norm() < most && (V.w_WB - w).norm() < most;
}

/// Rotated about the origin, about an axis that is not special to a box.
Body turned(Body body) {
  const Quaternion q{2, 1, 2, 0};
  const Mat3 R = lin_canny::rotation(q);
  body.X_WB.p_WB = R * body.X_WB.p_WB;
  body.X_WB.q_WB = q;  // of bodies that were not rotated
  body.velocity.v_WBcm = R * body.velocity.v_WBcm;
  body.velocity.w_WB = R * body.velocity.w_WB;
  return body;
}

TEST_CASE("simultaneous impact: a box that falls flat leaves flat with e times its speed") {
  for (const Vec3& half : {Vec3(1, 1, 1), Vec3(1, 2, 0.5), Vec3(0.25, 0.5, 4), Vec3(1, 0.001, 1)}) {
    for (const double e : {0.0, 0.5, 1.0}) {
      for (const double mu : {0.0, 0.5}) {
        CAPTURE(half.transpose(), e, mu);
        const Body box = falling(half, 1, {0, 0, -1}, {e, mu});
        CHECK(is_near(velocity_after({box, table()}), {0, 0, e}));
        CHECK(is_near(velocity_after({table(), box}, 1), {0, 0, e}));
        const Vec3 up = lin_canny::rotation({2, 1, 2, 0}) * Vec3(0, 0, 1);
        CHECK(is_near(velocity_after({turned(box), turned(table())}), e * up));
      }
    }
  }
}

TEST_CASE("simultaneous impact: neither the order of vertices nor a mirror changes how a polytope leaves") {
  std::vector<Vec3> corners;
  for (int k = 0; k < 8; ++k) corners.emplace_back(k & 1 ? 1 : -1, k & 2 ? 2 : -2, k & 4 ? 0.5 : -0.5);
  const auto after = [&](const std::vector<Vec3>& vertices, const Vec3& v, const Vec3& w) {
    Body body = falling({1, 2, 0.5}, 1, v, {0.5, 0.25});
    body.shape = Polytope{vertices, {}};
    body.velocity.w_WB = w;
    const Scene scene = reference::completed(moving_scene({body, table()}, none, {2}));
    return simulate(scene).trajectory.states.back()[0].velocity;
  };
  const Vec3 v(0.5, 0.25, -1);
  const Velocity first = after(corners, v, none);
  for (int k = 0; k < 12; ++k) {
    std::rotate(corners.begin(), corners.begin() + 1 + k % 3, corners.end());
    std::swap(corners[0], corners[static_cast<std::size_t>(1 + k % 7)]);
    CHECK(is_near(after(corners, v, none), first.v_WBcm, first.w_WB));
  }
  const Velocity other = after(corners, {-v.x(), v.y(), v.z()}, none);
  CHECK(is_near(other, {-first.v_WBcm.x(), first.v_WBcm.y(), first.v_WBcm.z()}, none));
}

// Friction 1/2 of the normal impulse 3/2 at all times; the pressure moves forward by mu h, so that nothing tips.
TEST_CASE("simultaneous impact: a cube that lands flat and slides keeps flat") {
  CHECK(is_near(velocity_after({falling({1, 1, 1}, 1, {2, 0, -1}, {0.5, 0.5}), table()}), {1.25, 0, 0.5}));
  const Vec3 slip(1.2, 1.6, 0);
  CHECK(is_near(velocity_after({falling({1, 1, 1}, 1, slip - Vec3(0, 0, 1), {0.5, 0.25}), table()}),
                Vec3(0, 0, 0.5) + (2 - 0.375) / 2 * slip));
}

TEST_CASE("simultaneous impact: two cubes that meet face to face exchange their velocities") {
  const auto cube = [](double x, double v) {
    Body body = brick({1, 1, 1}, {x, 0, 0}, {1, 0});
    body.velocity.v_WBcm = {v, 0, 0};
    return body;
  };
  CHECK(is_near(velocity_after({cube(-2, 1), cube(2, -1)}), {-1, 0, 0}));
  CHECK(is_near(velocity_after({cube(-2, 1), cube(2, -1)}, 1), {1, 0, 0}));
  CHECK(is_near(velocity_after({cube(-2, 3), cube(2, 1)}), {1, 0, 0}));
}

TEST_CASE("simultaneous impact: a ball breaks two symmetrically, at any numbers of the three") {
  for (const double e : {1.0, 0.5}) {
    const Vec3 striker = e == 1 ? Vec3(-7.0 / 57, 0, 0) : Vec3(3.0 / 19, 0, 0);
    const Vec3 first = e == 1 ? Vec3(32.0 / 57, 8.0 / 19, 0) : Vec3(8.0 / 19, 6.0 / 19, 0);
    const std::array<Body, 3> balls = {ball(0.5, {-1, 0, 0}, {1, 0, 0}, {e, 0}), ball(0.5, {0.8, 0.6, 0}, none, {e, 0}),
                                       ball(0.5, {0.8, -0.6, 0}, none, {e, 0})};
    std::array<std::size_t, 3> order = {0, 1, 2};
    do {
      std::vector<Body> bodies;
      for (const std::size_t k : order) bodies.push_back(balls[k]);
      const Simulated done = simulate(moving_scene(bodies, none, {1.5}));
      CHECK(done.statistics.of(Event::Kind::impact) == 2);
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 expected = order[k] == 0 ? striker : Vec3(first.x(), order[k] == 1 ? first.y() : -first.y(), 0);
        CHECK(is_near(done.trajectory.states.back()[k].velocity, expected));
      }
    } while (std::ranges::next_permutation(order).found);
  }
}

TEST_CASE("simultaneous impact: a body that starts later takes no part") {
  const Body late = ball(0.5, {1, 0, 0}, {-1, 0, 0}, {1, 0});
  Scene scene =
      moving_scene({ball(0.5, {-2, 0, 0}, {1, 0, 0}, {1, 0}), ball(0.5, none, none, {1, 0}), late}, none, {1.25});
  scene.motion->start_times = {0, 0, 2};
  scene.motion->sample_times = {1.25};
  const Simulated done = simulate(scene);
  CHECK(is_near(done.trajectory.states.back()[0].velocity, none));
  CHECK(is_near(done.trajectory.states.back()[1].velocity, {1, 0, 0}));
}

TEST_CASE("simultaneous impact: Newton's cradle, and a row that is hit from both sides") {
  const auto row = [](const std::vector<double>& x, const std::vector<double>& v) {
    std::vector<Body> bodies;
    for (std::size_t k = 0; k < x.size(); ++k) bodies.push_back(ball(0.5, {x[k], 0, 0}, {v[k], 0, 0}, {1, 0}));
    const Simulated done = simulate(moving_scene(bodies, none, {4}));
    std::vector<double> after;
    for (const State& state : done.trajectory.states.back()) after.push_back(state.velocity.v_WBcm.x());
    return after;
  };
  const auto are_near = [](const std::vector<double>& a, const std::vector<double>& b) {
    return std::ranges::equal(a, b, [](double p, double q) { return std::abs(p - q) < 1e-12; });
  };
  CHECK(are_near(row({-3, -2, 0, 1, 2}, {1, 1, 0, 0, 0}), {0, 0, 0, 1, 1}));
  CHECK(are_near(row({-4, -3, -2, 0, 1}, {1, 1, 1, 0, 0}), {0, 0, 1, 1, 1}));
  CHECK(are_near(row({-2, 0, 2}, {1, 0, -1}), {-1, 0, 1}));
  CHECK(are_near(row({-3, -1, 0, 1, 3}, {1, 0, 0, 0, -1}), {-1, 0, 0, 0, 1}));
}

TEST_CASE("simultaneous impact: a row that touches and is hit from both ends stays symmetric") {
  for (const double e : {1.0, 0.5, 0.0}) {
    std::vector<Body> bodies;
    for (const double x : {-3.0, 0.0, 2.0, 4.0, 7.0}) bodies.push_back(ball(1, {x, 0, 0}, none, {e, 0}));
    bodies.front().velocity.v_WBcm = {2, 0, 0};
    bodies.back().velocity.v_WBcm = {-2, 0, 0};
    const Simulated done = simulate(moving_scene(bodies, none, {1}));
    const std::vector<State>& after = done.trajectory.states.back();
    for (std::size_t k = 0; k < 5; ++k) {
      CHECK(after[k].velocity.v_WBcm.x() == Approx(-after[4 - k].velocity.v_WBcm.x()).margin(1e-12));
    }
    const std::vector<Event>& events = *done.trajectory.events;
    CHECK(events[0].time == events[1].time);
    CHECK(std::pair(events[0].a, events[0].b) == std::pair(0, 1));
    CHECK(std::pair(events[1].a, events[1].b) == std::pair(3, 4));
  }
}

TEST_CASE("simultaneous impact: a box onto two pillars") {
  const auto pillar = [](double from, double to, double e) {
    return fixed(brick({(to - from) / 2, 1, 1}, {(from + to) / 2, 0, -1}, {e, 10}));
  };
  for (const double mu : {0.0, 0.5}) {
    const Body beam = falling({3, 1, 0.5}, 1, {0, 0, -1}, {0.5, mu});
    CHECK(is_near(velocity_after({beam, pillar(-3, -1, 1), pillar(1, 3, 1)}), {0, 0, 0.5}));
    CHECK(is_near(velocity_after({pillar(1, 2, 1), beam, pillar(-3, -1, 1)}, 1), {0, 0, 0.5}));
    // The pillars as parts of one body: one region.
    Body both = fixed(brick({1, 1, 1}, {0, 0, -1}, {1, 10}));
    both.shape = Compound{{Part{Pose{{-2, 0, 0}, {}}, Box{{1, 1, 1}}}, Part{Pose{{1.5, 0, 0}, {}}, Box{{0.5, 1, 1}}}}};
    CHECK(is_near(velocity_after({beam, both}), {0, 0, 0.5}));
  }
  // Different restitution. No wrench has a torque: all p with Σ p = m and Σ p x = 0. The least Σ ½ Wᵀ M⁻¹ W presses
  // half at −1 and half at 1. v' = 1/2 upward, and ω' = −(1/2 m)/I about y: I/m = (3² + 1/2²)/3.
  const Body beam = falling({3, 1, 0.5}, 1, {0, 0, -1}, {1, 0});
  const Velocity V = velocity_after({beam, pillar(-3, -1, 1), pillar(1, 3, 0)}, 0, 1.25);
  CHECK(is_near(V, {0, 0, 0.5}, {0, 0.5 / (9.25 / 3), 0}, 1e-9));
}

// Two blocks of one body stand on a table, turn and sink. Without restitution both stop, or one turns about the other.
TEST_CASE("simultaneous impact: the rounding that an impact leaves is no further impact") {
  const auto block = [](double x) { return Part{{{x, 0, 0}, {}}, Box{Vec3(0.25, 0.25, 0.25)}}; };
  for (const double centre : {0.0, 0.5}) {
    for (const double spin : {-0.75, 0.5, 2.0}) {
      Body blocks = falling({0.25, 0.25, 0.25}, 0, {0, 0, -1}, {0, 0});
      blocks.shape = Compound{{block(-1), block(1)}};
      blocks.mass = MassProperties{1, {centre, 0, 0}, 0.0625 * Mat3::Identity()};
      blocks.velocity.w_WB = {0, spin, 0};
      const Simulated done = simulate(moving_scene({blocks, table()}, none, {0x1p-10}));
      INFO(centre << " " << spin);
      REQUIRE(!done.stopped);
      CHECK(done.trajectory.events->size() <= 4);
      const double speed = done.trajectory.states.back()[0].velocity.v_WBcm.norm();
      CHECK((speed < 1e-12 || speed > 1e-3));
    }
  }
}

// Rounding may leave no contact point with a positive impulse, though the parts approach.
TEST_CASE("simultaneous impact: parts that approach by less than the least normal number") {
  const auto block = [](double x) { return Part{{{x, 0, 0}, {}}, Box{Vec3(0.25, 0.25, 0.25)}}; };
  Body blocks = falling({0.25, 0.25, 0.25}, 0, {0, 0, -1e-310}, {0, 0});
  blocks.shape = Compound{{block(-1), block(1)}};
  blocks.mass = MassProperties{1, {0.5, 0, 0}, 0.0625 * Mat3::Identity()};
  blocks.velocity.w_WB = {0, 2e-310, 0};
  const Simulated done = simulate(moving_scene({blocks, table()}, none, {1}));
  CHECK(done.trajectory.states.back()[0].X_WB.p_WB.z() == 0.25);
}

TEST_CASE("simultaneous impact: a ball that falls into a wedge") {
  const auto plane = [](double sign) {
    Body body = fixed(brick({4, 4, 1}, none, {1, 10}));
    const double half = std::atan2(0.8, 0.6) / 2;  // the normal is (sign 4/5, 0, 3/5)
    body.X_WB.q_WB = {std::cos(half), 0, sign * std::sin(half), 0};
    body.X_WB.p_WB = -Vec3(sign * 0.8, 0, 0.6);
    return body;
  };
  for (const double e : {1.0, 0.5, 0.0}) {
    // It touches both at a height of 1/0.6 for a radius of 1.
    const Body body = ball(1, {0, 0, 1 / 0.6 + 1}, {0, 0, -1}, {e, 0});
    CHECK(is_near(velocity_after({body, plane(1), plane(-1)}, 0, 1.5), {0, 0, e}, none, 1e-9));
  }
}

// A heavy cube that presses a light one onto a table with e = 1/2 ends in infinitely many impacts, and the run stops.
TEST_CASE("simultaneous impact: masses that differ by a factor of a million, without a spin") {
  for (const double mass : {1e6, 1e-6}) {
    for (const double e : {0.0, 0.5, 1.0}) {
      for (const double mu : {0.0, 0.5}) {
        if (mass > 1 && e == 0.5) continue;
        CAPTURE(mass, e, mu);
        Body low = falling({1, 1, 1}, 0.5, {0, 0, -1}, {e, mu}), high = falling({1, 1, 1}, 3, {0, 0, -1}, {e, mu});
        low.mass = MassProperties{1, none, 2.0 / 3 * Mat3::Identity()};
        high.mass = MassProperties{mass, none, mass * 2 / 3 * Mat3::Identity()};
        const Scene scene = moving_scene({low, high, table()}, none, {4});
        const Simulated done = simulate(scene);
        REQUIRE(!done.stopped);
        const std::vector<State>& last = done.trajectory.states.back();
        const double before = kinetic(scene), after = kinetic(scene, last);
        CHECK(after <= before * (1 + 1e-12));
        if (e == 1) CHECK(after == Approx(before).epsilon(1e-9));
        for (std::size_t k = 0; k < 2; ++k) CHECK(last[k].velocity.w_WB.norm() < 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace touchstone::fast::simulation
