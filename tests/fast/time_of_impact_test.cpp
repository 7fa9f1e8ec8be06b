#include "fast/time_of_impact.h"

#include <cmath>
#include <utility>

#include "fast/distance.h"
#include "fast/lin_canny/nearest_parts.h"
#include "fast/mark.h"
#include "fast/time_of_impact/first_contact.h"
#include "model/input_error.h"
#include "reference/time_of_impact.h"
#include "reference/validity.h"
#include "tests/catch.h"
#include "tests/fast/motion/random_motion.h"

namespace touchstone::fast {
namespace {

using Status = TimeOfImpact::Status;
using tests::RandomMotion;

/// Two balls of radius 1/2 on the x axis at -2 and 2, moving towards each other at speed 1 unless a test changes that.
Scene balls() {
  Scene scene;
  for (const double side : {-1.0, 1.0}) {
    Body ball;
    ball.name = std::string(side < 0 ? "A" : "B");
    ball.shape = Sphere{0.5};
    ball.X_WB.p_WB = Vec3(2 * side, 0, 0);
    ball.velocity.v_WBcm = Vec3(-side, 0, 0);
    scene.bodies.push_back(ball);
  }
  scene.motion.emplace();
  scene.motion->sample_times = {10};
  return scene;
}

/// A cube of side 1 whose lower face is `height` above a fixed table, moving down at speed v.
Scene cube_over_table(double height, double v) {
  Scene scene;
  scene.gravity = Vec3(0, 0, -9.8);
  Body cube, table;
  cube.name = std::string("cube");
  cube.shape = Box{Vec3(0.5, 0.5, 0.5)};
  cube.X_WB.p_WB = Vec3(0, 0, 0.5 + height);
  cube.velocity.v_WBcm = Vec3(0, 0, -v);
  table.name = std::string("table");
  table.shape = Box{Vec3(8, 8, 1)};
  table.X_WB.p_WB = Vec3(0, 0, -1);
  table.mass = Fixed{};
  scene.bodies = {cube, table};
  scene.motion.emplace();
  scene.motion->sample_times = {2};
  return scene;
}

void check_holds(const TimeOfImpact& found, double truth, double width) {
  REQUIRE(found.status == Status::hit);
  CHECK(found.enclosure->lo <= truth);
  CHECK(found.enclosure->hi >= truth);
  CHECK(found.enclosure->hi - found.enclosure->lo <= width);
}

TEST_CASE("balls: head-on, from the side, missing, falling alike") {
  Scene scene = balls();
  check_holds(time_of_impact_of(scene), 1.5, 1e-13);
  scene.gravity = Vec3(0, -9.81, 3);
  check_holds(time_of_impact_of(scene), 1.5, 1e-12);
  scene.bodies[0].X_WB.p_WB.y() = 0.6;  // contact at distance sqrt(1 − 0.36) = 0.8 along x, up to 0.6's rounding
  check_holds(time_of_impact_of(scene), 1.6, 1e-12);
  scene.bodies[0].X_WB.p_WB.y() = 1.25;
  CHECK(time_of_impact_of(scene).status == Status::miss);
}

TEST_CASE("a ball under gravity meets one that is fixed") {
  Scene scene = balls();
  scene.gravity = Vec3(0, 0, -2);
  scene.bodies[1].mass = Fixed{};
  scene.bodies[1].velocity = {};
  scene.bodies[1].X_WB.p_WB = Vec3(-2, 0, -5);
  scene.bodies[0].velocity = {};
  check_holds(time_of_impact_of(scene), 2, 1e-13);  // 4 m of fall
}

TEST_CASE("a cube falls flat on a table") {
  check_holds(time_of_impact_of(cube_over_table(4.9, 0)), 1, 1e-12);
  Scene scene = cube_over_table(1, 2);
  scene.gravity = Vec3::Zero();
  check_holds(time_of_impact_of(scene), 0.5, 1e-13);
}

TEST_CASE("contact at the start counts if the two approach there") {
  const TimeOfImpact at_once = time_of_impact_of(cube_over_table(0, 1));
  check_holds(at_once, 0, 1e-12);
  CHECK(at_once.enclosure->lo == 0);
  Scene scene = cube_over_table(0, -1);
  scene.motion->sample_times = {0.125};
  CHECK(time_of_impact_of(scene).status == Status::miss);
  scene.motion->sample_times = {2};
  const TimeOfImpact back = time_of_impact_of(scene);
  CHECK(back.enclosure->lo == Approx(1 / 4.9).epsilon(1e-12));
  CHECK_THROWS_AS(time_of_impact_of(cube_over_table(-0.25, 0)), InputError);
}

TEST_CASE("a scene that is no motion of two bodies is refused") {
  Scene still = cube_over_table(1, 0);
  still.motion = std::nullopt;
  CHECK_THROWS_AS(time_of_impact_of(still), InputError);
  Scene alone = cube_over_table(1, 0);
  alone.bodies.pop_back();
  CHECK_THROWS_AS(time_of_impact_of(alone), InputError);
}

TEST_CASE("what pushes a body from its start is felt, a later push is refused") {
  Scene scene = cube_over_table(1, 0);
  scene.gravity = Vec3::Zero();
  scene.bodies[0].mass = MassProperties{2, Vec3::Zero(), Mat3::Identity()};
  scene.motion->force_bound = 8;
  scene.motion->forces = {{0, 0, Vec3(0, 0, -4)}};  // 2 m/s²: 1 m in 1 s
  scene.motion->sample_times = {4};
  check_holds(time_of_impact_of(scene), 1, 1e-12);
  scene.motion->forces[0].time = 0.5;
  CHECK_THROWS_AS(time_of_impact_of(scene), InputError);
}

TEST_CASE("a pair meets when the reference says it does") {
  RandomMotion random(3);
  int hits = 0, misses = 0;
  for (int i = 0; i < 240; ++i) {
    // The truth of tumbling bodies costs milliseconds a radian: one pair in eight.
    const int kinds[] = {0, 0, 0, 1, 2, 2, 1, 4};
    Scene drawn = random.pair(kinds[i % 8], i % 8 < 6 ? 0 : 2);
    if (i % 8 >= 4) {
      for (Body& b : drawn.bodies) b.mass = MassProperties{1, Vec3::Zero(), Mat3::Identity()};
    }
    const Scene scene = reference::completed(drawn);
    const TimeOfImpact found = time_of_impact_of(scene);
    const reference::TimeOfImpactTruth truth = reference::time_of_impact(scene);
    CAPTURE(i);
    REQUIRE(found.status == truth.status);
    if (found.status == Status::miss) ++misses;
    if (found.status != Status::hit) continue;
    ++hits;
    CAPTURE(found.enclosure->lo, found.enclosure->hi, truth.time.lo, truth.time.hi);
    REQUIRE(found.enclosure->lo <= truth.time.hi);
    REQUIRE(found.enclosure->hi >= truth.time.lo);
  }
  CHECK(hits > 50);
  CHECK(misses > 10);
}

TEST_CASE("a split flight meets when the whole one does") {
  RandomMotion random(5);
  for (int i = 0; i < 100; ++i) {
    const Scene scene = random.pair(i % 4, (i / 4) % 4);
    const motion::RigidBodyModel A(scene.bodies[0]), B(scene.bodies[1]);
    const motion::BallisticMotion a(A, 0, scene.bodies[0].X_WB, scene.bodies[0].velocity, scene.gravity);
    const motion::BallisticMotion b(B, 0, scene.bodies[1].X_WB, scene.bodies[1].velocity, scene.gravity);
    const FirstContact whole = first_contact(a, b, 0, 2);
    const double split = 2 * random.unit();
    FirstContact parts = first_contact(a, b, 0, split);
    if (parts.status == Status::miss) parts = first_contact(a, b, split, 2);
    CAPTURE(i, split);
    REQUIRE(whole.status == parts.status);
    if (whole.status != Status::hit) continue;
    REQUIRE(whole.lo <= parts.hi);
    REQUIRE(parts.lo <= whole.hi);
  }
}

TEST_CASE("with an envelope, a hit is a time at which the two are within it") {
  RandomMotion random(7);
  for (int i = 0; i < 60; ++i) {
    Scene scene = random.pair(i % 4, (i / 4) % 4);
    const motion::RigidBodyModel A(scene.bodies[0]), B(scene.bodies[1]);
    const motion::BallisticMotion a(A, 0, scene.bodies[0].X_WB, scene.bodies[0].velocity, scene.gravity);
    const motion::BallisticMotion b(B, 0, scene.bodies[1].X_WB, scene.bodies[1].velocity, scene.gravity);
    const FirstContact met = first_contact(a, b, 0, 2, 1e-9);
    if (met.status != Status::hit) continue;
    REQUIRE(met.lo == met.hi);
    scene.bodies[0].X_WB = a.pose(met.lo);
    scene.bodies[1].X_WB = b.pose(met.lo);
    const Distance there = distance(scene);
    CAPTURE(i, met.lo, *there.distance);
    REQUIRE(*there.distance <= 1.1e-9);
    REQUIRE((*there.p_WCa - met.p_WC).norm() <= 1e-7);
    REQUIRE(std::abs(met.nhat_BA_W.norm() - 1) <= 1e-15);
  }
}

/// at_first is a multiple of 1/8 m, from 0; the rate of 1/4 m/s, from 0. Now and then at_first is so large that the
/// inflated bodies overlap from the beginning.
Inflation drawn_inflation(RandomMotion& random, int i) {
  Inflation inflation;
  inflation.since = i % 2 == 0 ? 0 : -random.unit();
  inflation.at_first = i % 16 == 15 ? 8 : (i % 3) / 8.0;
  inflation.rate = i % 5 / 4.0;
  return inflation;
}

TEST_CASE("swollen, the two are apart before they meet by more than the swelling, and then no farther") {
  RandomMotion random(13);
  int hits = 0, misses = 0, at_once = 0;
  for (int i = 0; i < 240; ++i) {
    Scene scene = random.pair(i % 3, (i / 3) % 3);
    if (i % 7 == 0) scene.bodies[1].mass = Fixed{};
    const motion::RigidBodyModel A(scene.bodies[0]), B(scene.bodies[1]);
    const motion::BallisticMotion a(A, 0, scene.bodies[0].X_WB, scene.bodies[0].velocity, scene.gravity);
    const motion::BallisticMotion b(B, 0, scene.bodies[1].X_WB, scene.bodies[1].velocity, scene.gravity);
    const Inflation inflation = drawn_inflation(random, i);
    const double from = i % 4 == 3 ? random.unit() / 4 : 0, until = 2, envelope = i / 2 % 2 == 0 ? 0 : 1e-9;
    std::vector<lin_canny::FeaturePair> memory(1), walk(1);
    const FirstContact met = first_contact(a, b, from, until, envelope, memory, inflation);
    const auto farther_by = [&](double t) {
      const lin_canny::CachedPose at_a(a.pose(t)), at_b(b.pose(t));
      const double thicker = inflation.at_first + inflation.rate * (t - inflation.since);
      return nearest_parts(A.solid, at_a, B.solid, at_b, walk).proximity.distance - thicker;
    };
    CAPTURE(i, from, inflation.since, inflation.at_first, inflation.rate, met.lo, met.hi);
    for (int k = 0; met.lo > from && k < 64; ++k) {
      const double early = from + (met.lo - from) * (k / 64.0), late = met.lo - std::ldexp(met.lo - from, -k);
      CAPTURE(early, late);
      REQUIRE(farther_by(early) > -1e-12);
      REQUIRE(farther_by(late) > -1e-12);
    }
    if (met.status == Status::miss) {
      ++misses;
      REQUIRE(met.lo == until);
      REQUIRE(farther_by(until) > -1e-12);
    }
    if (met.status != Status::hit) continue;
    ++hits;
    if (met.lo == from) ++at_once;
    REQUIRE(farther_by(met.hi) <= 1e-9 + 1e-12);
    REQUIRE(met.hi - met.lo <= 1e-6);
  }
  CHECK(hits > 100);
  CHECK(misses > 10);
  CHECK(at_once >= 15);
}

TEST_CASE("sizes and spins at the ends of what is used") {
  for (const double size : {1e-6, 1.0, 1e6}) {
    Scene scene = cube_over_table(1, 0);
    scene.gravity = Vec3::Zero();
    scene.bodies[0].shape = Box{Vec3(0.5, 0.5, 0.5) * size};
    scene.bodies[1].shape = Box{Vec3(8, 8, 1) * size};
    scene.bodies[0].X_WB.p_WB = Vec3(0, 0, 4 * size);
    scene.bodies[1].X_WB.p_WB = Vec3(0, 0, -size);
    scene.bodies[0].velocity = {Vec3(0, 0, -size), Vec3(0, 0, 1e4)};  // spins flat: the face's height is 7/2 sizes
    scene.motion->sample_times = {8};
    const TimeOfImpact found = time_of_impact_of(scene);
    CAPTURE(size);
    check_holds(found, 3.5, 1e-6);
  }
}

// Two balls about the bodies come so near that the time until they touch is below the rounding of the time.
TEST_CASE("bodies from 2^58 m away are told from contact in a few steps, and within rounding") {
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].shape = Box{Vec3(2, 3, 2)};
  scene.bodies[1].shape = Sphere{3};
  scene.bodies[1].X_WB.p_WB = Vec3(0x1p58, -3, 0);
  scene.bodies[1].velocity.v_WBcm = Vec3(-0x1p59, 0, 0);
  scene.motion.emplace();
  scene.motion->sample_times = {2};
  const MarkCounts before = mark_counts;
  const TimeOfImpact said = time_of_impact_of(scene);
  constexpr auto balls = static_cast<std::size_t>(Mark::toi_balls);
  CHECK(mark_counts[balls] - before[balls] < 16);
  REQUIRE(said.enclosure.has_value());
  CHECK(said.enclosure->lo <= 0.5);
  CHECK(said.enclosure->hi >= 0.5);
  CHECK(said.enclosure->hi - said.enclosure->lo < 0x1p-40);
}

TEST_CASE("needles meet when the reference says they do") {
  RandomMotion random(11);
  int hits = 0;
  for (int i = 0; i < 24; ++i) {
    Scene scene = random.pair(1, 1);
    const double width = std::ldexp(1.0, -10 - i % 11);
    scene.bodies[0].shape = Box{Vec3(1, width, width)};
    scene.bodies[1].shape = Box{Vec3(width, 1, 1)};
    scene.bodies[1].velocity.w_WB = Vec3::Zero();
    const TimeOfImpact found = time_of_impact_of(scene);
    const reference::TimeOfImpactTruth truth = reference::time_of_impact(scene);
    CAPTURE(i, width);
    REQUIRE(found.status == truth.status);
    if (found.status != Status::hit) continue;
    ++hits;
    REQUIRE(found.enclosure->lo <= truth.time.hi);
    REQUIRE(found.enclosure->hi >= truth.time.lo);
    REQUIRE(found.enclosure->hi - found.enclosure->lo < 1e-9);
  }
  CHECK(hits > 8);
}

// A ball of radius r about the origin, and a sliver whose edge of 2 m starts 2⁻¹⁸ m beside the ball's highest point and
// turns down about it: the ball's centre is √(r² cos²θ + 2⁻³⁶) from the edge's line, and r at sin θ = 2⁻¹⁸ / r. At
// first the closest points of the vertex and of the edge are equally near within rounding.
TEST_CASE("an edge that turns about its end meets a ball, at first as near as the end is") {
  constexpr double r = 0x1p-9;
  Scene scene = balls();
  scene.bodies[0].shape = Sphere{r};
  scene.bodies[1].shape =
      Polytope{{{0, 0, 2 * r}, {0, -0.25, 0}, {-2, 0, 0}, {0, 0, 0}}, {{0, 1, 3}, {0, 2, 1}, {0, 3, 2}, {1, 2, 3}}};
  scene.bodies[0].X_WB.p_WB = Vec3::Zero();
  scene.bodies[1].X_WB.p_WB = Vec3(0, -0x1p-18, r);
  for (Body& body : scene.bodies) {
    body.mass = Fixed{};
    body.velocity = {};
  }
  scene.bodies[1].velocity.w_WB = Vec3(0, -1, 0);
  check_holds(time_of_impact_of(scene), std::asin(0x1p-18 / r), 1e-7);
  std::swap(scene.bodies[0], scene.bodies[1]);
  check_holds(time_of_impact_of(scene), std::asin(0x1p-18 / r), 1e-7);
}

// A ball of radius r, and a sliver that turns about a corner √2 r from the ball's centre. One edge there touches the
// ball at the start and turns away; the other, 1 m long, comes after half a turn. From 3/4 π on it is nearer than the
// corner, by less than rounding until it has turned by 1e-7.
TEST_CASE("an edge that turns about its end meets a speck beside the end, and no sooner") {
  constexpr double r = 0x1p-30;
  Scene scene = balls();
  scene.bodies[0].shape = Sphere{r};
  scene.bodies[1].shape = Polytope{{{0, 0, -0x1p-9}, {0, 0x1p-20, -0x1p-9}, {-1, 0, 0}, {0, 0, 0}},
                                   {{0, 1, 3}, {0, 2, 1}, {0, 3, 2}, {1, 2, 3}}};
  scene.bodies[0].X_WB.p_WB = Vec3::Zero();
  scene.bodies[1].X_WB.p_WB = Vec3(-r, 0, r);
  for (Body& body : scene.bodies) {
    body.mass = Fixed{};
    body.velocity = {};
  }
  scene.bodies[1].velocity.w_WB = Vec3(0, 1, 0);
  scene.motion->sample_times = {4};
  check_holds(time_of_impact_of(scene), std::acos(-1.0), 1e-4);
}

}  // namespace
}  // namespace touchstone::fast
