#include "reference/time_of_impact.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "model/input_error.h"
#include "reference/ballistic_motion.h"
#include "reference/distance.h"
#include "reference/rational.h"
#include "reference/validity.h"
#include "tests/catch.h"
#include "tests/reference/fine_motion.h"
#include "tests/reference/moving_scenes.h"

namespace touchstone::tests {
namespace {

using Status = TimeOfImpact::Status;
using reference::Rational;
using reference::time_of_distance;
using reference::time_of_impact;
using reference::TimeOfImpactTruth;

Body ball(double radius, const Vec3& p, const Vec3& v) {
  Body b = body(Sphere{radius}, p);
  b.velocity.v_WBcm = v;
  return b;
}

/// |p + v t|² − r² of two balls under the same gravity, exactly.
Rational excess(const Scene& scene, double time) {
  const Body& a = scene.bodies[0];
  const Body& b = scene.bodies[1];
  Rational square;
  for (int i = 0; i < 3; ++i) {
    const Rational x = Rational(a.X_WB.p_WB[i]) - Rational(b.X_WB.p_WB[i]) +
                       (Rational(a.velocity.v_WBcm[i]) - Rational(b.velocity.v_WBcm[i])) * Rational(time);
    square += x * x;
  }
  const Rational r = Rational(std::get<Sphere>(a.shape).radius) + Rational(std::get<Sphere>(b.shape).radius);
  return square - r * r;
}

Scene two_balls(Dice& dice, double offset) {
  const Vec3 p = 4 * dice.in_cube().normalized();
  const Vec3 side = p.cross(dice.in_cube()).normalized();
  Scene scene = pair(ball(1, Vec3::Zero(), dice.in_cube()), ball(0.5, p + offset * side, Vec3::Zero()));
  scene.bodies[0].velocity.w_WB = dice.in_cube();
  scene.bodies[1].velocity.v_WBcm = scene.bodies[0].velocity.v_WBcm - (2 + dice.unit()) * p / 4;
  scene.gravity = Vec3(0, 0, -9.8125);
  return moving_scene(scene, 8);
}

TEST_CASE("Balls meet when their quadratic says so, exactly") {
  Dice dice(1);
  for (int i = 0; i < 200; ++i) {
    const double offset = 3 * dice.unit();
    const Scene scene = two_balls(dice, offset);
    const TimeOfImpactTruth truth = time_of_impact(scene);
    CAPTURE(i, offset, truth.time.lo, truth.time.hi);
    REQUIRE(truth.status != Status::undecided);
    if (truth.status == Status::hit) {
      CHECK(excess(scene, truth.time.lo) >= 0);
      CHECK(excess(scene, truth.time.hi) <= 0);
      CHECK(truth.time.hi - truth.time.lo < 1e-13);
    } else {
      CHECK(offset > 1.49);
    }
    for (int k = 1; k < 16; ++k) CHECK(excess(scene, truth.time.lo * k / 16) > 0);
  }
}

TEST_CASE("Balls that graze are told apart to the last bit of their offset") {
  Dice dice(2);
  for (int k = 10; k <= 52; k += 3) {
    for (const double side : {-1.0, 1.0}) {
      Scene scene = pair(ball(1, Vec3(-4, 1.5 + side * std::ldexp(1, -k), 0), Vec3(1, 0, 0)),
                         ball(0.5, Vec3::Zero(), Vec3::Zero()));
      const TimeOfImpactTruth truth = time_of_impact(moving_scene(scene, 8));
      CAPTURE(k, side);
      CHECK(truth.status == (side < 0 ? Status::hit : Status::miss));
      if (truth.status != Status::hit) continue;
      CHECK(excess(scene, truth.time.lo) >= 0);
      CHECK(excess(scene, truth.time.hi) <= 0);
    }
  }
  const Scene touching = pair(ball(1, Vec3(-4, 1.5, 0), Vec3(1, 0, 0)), ball(0.5, Vec3::Zero(), Vec3::Zero()));
  const TimeOfImpactTruth truth = time_of_impact(moving_scene(touching, 8));
  CHECK(truth.status == Status::hit);
  CHECK(truth.time == Interval{4, 4});
}

/// A box turned about z by arccos 3/5, whose faces z = ±1 slide along those of another; its corner (7/5, 1/5) leads.
Scene sliding_over(double z) {
  Scene scene = pair(body(Box{Vec3(1, 1, 1)}, Vec3(-4, 0, z)), body(Box{Vec3(1, 1, 1)}));
  scene.bodies[0].X_WB.q_WB = {2, 0, 0, 1};
  scene.bodies[0].velocity.v_WBcm = Vec3(1, 0, 0);
  return moving_scene(scene, 8);
}

void check_contains(const TimeOfImpactTruth& truth, const Rational& time) {
  CAPTURE(truth.time.lo, truth.time.hi);
  CHECK(truth.status == Status::hit);
  CHECK(Rational(truth.time.lo) <= time);
  CHECK(Rational(truth.time.hi) >= time);
  CHECK(truth.time.hi - truth.time.lo < 1e-14);
}

TEST_CASE("Bodies that translate and graze are told apart exactly") {
  SECTION("faces in one plane") {
    const Rational leads = Rational(8) / Rational(5);
    check_contains(time_of_impact(sliding_over(2)), leads);
    check_contains(time_of_impact(sliding_over(2 - 0x1p-51)), leads);
    CHECK(time_of_impact(sliding_over(2 + 0x1p-51)).status == Status::miss);
  }
  SECTION("in common gravity, and carried along") {
    Scene scene = sliding_over(2);
    scene.gravity = Vec3(0.5, 0, -8);
    for (Body& b : scene.bodies) b.velocity.v_WBcm += Vec3(3, -1, 0.25);
    check_contains(time_of_impact(scene), Rational(8) / Rational(5));
  }
  SECTION("a ball along an edge: where the edge begins") {
    Scene scene = pair(ball(5, Vec3(4, -8, 5), Vec3(0, 1, 0)), body(Box{Vec3(1, 1, 1)}));
    check_contains(time_of_impact(moving_scene(scene, 16)), Rational(7));
    scene.bodies[0].X_WB.p_WB.z() += 0x1p-50;
    CHECK(time_of_impact(moving_scene(scene, 16)).status == Status::miss);
  }
  SECTION("one starts later") {
    Scene scene = sliding_over(2);
    scene.bodies[1].X_WB.p_WB.x() += 1;
    scene.bodies[1].velocity.v_WBcm = Vec3(-1, 0, 0);
    scene.motion->start_times = {0, 1};
    check_contains(time_of_impact(scene), Rational(9) / Rational(5));  // 8/5 after 1 s, then at twice the speed
  }
  SECTION("one part grazes, another one comes later") {
    Compound two;
    two.parts = {{{Vec3(0, 0, 2), {}}, Box{Vec3(1, 1, 1)}}, {{Vec3(4, 0, 0), {}}, Box{Vec3(1, 1, 1)}}};
    Scene scene = pair(body(Box{Vec3(1, 1, 1)}, Vec3(-4, 0, 0)), body(two));
    scene.bodies[0].velocity.v_WBcm = Vec3(1, 0, 0);
    scene.motion = Motion{.sample_times = {16}};
    check_contains(time_of_impact(scene), Rational(2));
  }
}

TEST_CASE("A body that is farther away than doubles reach when the other one starts misses it") {
  Scene scene = pair(ball(1, Vec3(-4, 1.5, 0), Vec3(1e300, 0, 0)), ball(0.5, Vec3::Zero(), Vec3::Zero()));
  scene.motion = Motion{.sample_times = {1e10}, .start_times = {0, 1e9}};
  CHECK(time_of_impact(scene).status == Status::miss);
}

TEST_CASE("Contact at a later start is decided where doubles hold the position there") {
  for (const double approach : {-1.0, 1.0}) {
    Scene scene = pair(body(Box{Vec3(1, 1, 1)}, Vec3(-4 - approach, 0, 0)), body(Box{Vec3(1, 1, 1)}, Vec3(-2, 0.5, 0)));
    scene.bodies[0].velocity.v_WBcm = Vec3(approach, 0, 0);
    scene.motion = Motion{.sample_times = {4}, .start_times = {0, 1}};
    const TimeOfImpactTruth truth = time_of_impact(scene);
    CHECK(truth.status == (approach > 0 ? Status::hit : Status::miss));
    if (approach > 0) CHECK(truth.time == Interval{1, 1});
  }
}

/// The 76 digits of fine_motion.h share no code with the reference, and neither does the test for a separating
/// axis.
void hold_to_fine_poses(const Scene& scene, const TimeOfImpactTruth& truth) {
  const FineMotion A(scene, 0), B(scene, 1);
  CAPTURE(truth.time.lo, truth.time.hi);
  CHECK(greatest_gap(A, B, truth.time.lo) > 0);
  if (truth.status == Status::hit) CHECK(greatest_gap(A, B, truth.time.hi) <= 0);
  for (const double part : {0.5, 0.9, 0.99, 1 - 0x1p-10, 1 - 0x1p-20, 1 - 0x1p-40}) {
    CHECK(greatest_gap(A, B, truth.time.lo * part) > 0);
  }
}

TEST_CASE("Hulls in flight are apart before lo and share points at hi, by poses of 76 digits") {
  Dice dice(3);
  std::vector<double> widths;
  for (int i = 0; i < 40; ++i) {
    const Scene scene = ballistic_pair(dice, i % 2 == 0 ? 6 : 10, i % 4 < 2 ? 5 : 40);
    const TimeOfImpactTruth truth = time_of_impact(scene);
    CAPTURE(i);
    REQUIRE(truth.status != Status::undecided);
    hold_to_fine_poses(scene, truth);
    if (truth.status == Status::hit) widths.push_back(truth.time.hi - truth.time.lo);
  }
  REQUIRE(widths.size() > 30);
  std::ranges::sort(widths);
  CHECK(widths[widths.size() / 2] < 2e-14);
  CHECK(widths.back() < 1e-12);
}

TEST_CASE("Hulls that graze, by bisection of their offset") {
  Dice dice(4);
  int undecided = 0;
  for (int i = 0; i < 8; ++i) {
    const Scene hits = ballistic_pair(dice, 6, 2);
    if (time_of_impact(hits).status != Status::hit) continue;
    const Vec3 side = hits.bodies[1].X_WB.p_WB.cross(dice.in_cube()).normalized();
    double in = 0, out = 4;
    for (int k = 0; k < 40; ++k) {
      Scene scene = hits;
      const double offset = (in + out) / 2;
      scene.bodies[1].X_WB.p_WB += offset * side;
      const TimeOfImpactTruth truth = time_of_impact(scene);
      CAPTURE(i, k, offset);
      if (k % 6 == 5) hold_to_fine_poses(scene, truth);
      undecided += truth.status == Status::undecided;
      (truth.status == Status::miss ? out : in) = offset;
    }
  }
  CHECK(undecided == 0);
}

/// Mirtich's bound in plain doubles: no point of the two comes nearer along d* faster than |v| + Σ |ω| ρ. Same gravity.
double conservative_advancement(Scene scene, double near) {
  double t = 0;
  for (int i = 0; i < 100000 && t < scene.motion->sample_times.back(); ++i) {
    double speed = 0;
    Scene now = scene;
    for (std::size_t k = 0; k < 2; ++k) {
      const FineMotion fine(scene, k);
      now.bodies[k].X_WB = fine.pose(t);
      speed += scene.bodies[k].velocity.w_WB.norm();
    }
    const reference::DistanceTruth d = reference::distance(now);
    if (d.verdict != Verdict::separated || d.distance.lo < near) break;
    const Vec3 n = (d.p_WCa - d.p_WCb).normalized();
    speed -= n.dot(scene.bodies[0].velocity.v_WBcm - scene.bodies[1].velocity.v_WBcm);
    if (speed <= 0) return INFINITY;
    t += d.distance.lo / speed * (1 - 1e-9);
  }
  return t;
}

// Their closest points may be anywhere in what the faces share, also at its border.
TEST_CASE("Boxes that meet face on face are known to meet, at the time of their ends") {
  Dice dice(8);
  const auto whole = [&](int least, int most) {
    return static_cast<double>(least) + std::floor(dice.unit() * (most - least + 1));
  };
  for (int i = 0; i < 60; ++i) {
    const int axis = i % 3;
    const Vec3 a(whole(1, 4), whole(1, 4), whole(1, 4)), b(whole(1, 4), whole(1, 4), whole(1, 4));
    Vec3 offset = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
      if (k != axis) offset[k] = std::floor(dice.unit() * (a[k] + b[k]));  // they share at least a strip of 1 m
    }
    const double time = whole(1, 8), speed = std::ldexp(1.0, static_cast<int>(whole(-2, 10)));
    offset[axis] = a[axis] + b[axis] + time * speed;
    Scene scene = pair(body(Box{a}, offset), body(Box{b}, Vec3::Zero()));
    scene.bodies[0].velocity.v_WBcm[axis] = -speed;
    const TimeOfImpactTruth truth = time_of_impact(moving_scene(scene, 16));
    REQUIRE(truth.status == Status::hit);
    CHECK(truth.time.lo <= time);
    CHECK(truth.time.hi >= time);
    CHECK(truth.time.hi - truth.time.lo < 1e-14);
  }
}

TEST_CASE("Conservative advancement comes to the same time") {
  Dice dice(5);
  for (int i = 0; i < 10; ++i) {
    const Scene scene = ballistic_pair(dice, 12, 2);
    const TimeOfImpactTruth truth = time_of_impact(scene);
    const double t = conservative_advancement(scene, 1e-9);
    CAPTURE(i, t);
    if (truth.status == Status::miss) {
      CHECK(t >= 2);
    } else {
      CHECK(t <= truth.time.hi + 1e-13);
      CHECK(greatest_gap(FineMotion(scene, 0), FineMotion(scene, 1), t) < 1e-8);
      CHECK(t > truth.time.lo - 1e-6);
    }
  }
}

/// Both 2 a side; contact in x = 1.
Scene touching_boxes(const Velocity& of_A) {
  Scene scene = pair(body(Box{Vec3(1, 1, 1)}), body(Box{Vec3(1, 1, 1)}, Vec3(2, 0.5, 0)));
  scene.bodies[0].velocity = of_A;
  return moving_scene(scene, 4);
}

TEST_CASE("Contact at the start counts if the two approach there") {
  CHECK(time_of_impact(touching_boxes({Vec3(1, 0, 0), Vec3::Zero()})).at_start);
  CHECK(time_of_impact(touching_boxes({Vec3(1, 0, 0), Vec3::Zero()})).status == Status::hit);
  CHECK(time_of_impact(touching_boxes({Vec3(1, 0, 0), Vec3::Zero()})).nhat_BA_W == Vec3(-1, 0, 0));
  CHECK(time_of_impact(touching_boxes({Vec3(-1, 0, 0), Vec3::Zero()})).status == Status::miss);
  SECTION("a turn that drives one edge of the contact in") {
    const TimeOfImpactTruth truth = time_of_impact(touching_boxes({Vec3::Zero(), Vec3(0, 0, 1)}));
    CHECK(truth.status == Status::hit);
    CHECK(truth.at_start);
  }
  SECTION("a turn that the parting outruns, until it comes back") {
    const TimeOfImpactTruth truth = time_of_impact(touching_boxes({Vec3(-1.25, 0, 0), Vec3(0, 0, 1)}));
    CHECK(!truth.at_start);
  }
  SECTION("sliding is neither") {
    const TimeOfImpactTruth truth = time_of_impact(touching_boxes({Vec3(0, 1, 0), Vec3::Zero()}));
    CHECK(truth.status == Status::undecided);
    CHECK(truth.at_start);
    CHECK(truth.gap == 0);
  }
  SECTION("turning on both sides") {
    for (const Shape& shape : {Shape(Box{Vec3(1, 1, 1)}), Shape(Sphere{1})}) {
      Scene scene = pair(body(shape), body(Box{Vec3(1, 1, 1)}, Vec3(2, 0, 0)));
      scene.bodies[0].velocity = {Vec3(-1, 0, 0), Vec3(1, 0.25, -0.125)};
      scene.bodies[1].velocity = {Vec3(0, 0.5, 0), Vec3(0.25, 0, 0.5)};
      scene = moving_scene(scene, 0.25);
      CHECK(time_of_impact(scene).status == Status::miss);
      std::swap(scene.bodies[0].velocity, scene.bodies[1].velocity);
      const TimeOfImpactTruth meets = time_of_impact(scene);
      CHECK(meets.status == Status::hit);
      CHECK(meets.at_start);
    }
  }
}

TEST_CASE("Balls that touch and part come back") {
  Scene scene = pair(ball(1, Vec3(0, 0, 2), Vec3(0, 0, 1)), ball(1, Vec3::Zero(), Vec3::Zero()));
  scene.bodies[1].mass = Fixed{};
  scene.gravity = Vec3(0, 0, -2);
  const TimeOfImpactTruth truth = time_of_impact(moving_scene(scene, 4));
  CHECK(truth.status == Status::hit);
  CHECK(truth.time.lo <= 1);
  CHECK(truth.time.hi >= 1);
  CHECK(truth.time.hi - truth.time.lo < 1e-14);
}

TEST_CASE("Overlap at the start is bad input, with the pair and the depth") {
  Scene scene = pair(ball(1, Vec3::Zero(), Vec3::Zero()), ball(1, Vec3(1.5, 0, 0), Vec3::Zero()));
  scene.bodies[0].name = "left";
  scene.bodies[1].name = "right";
  scene = moving_scene(scene, 1);
  CHECK_THROWS_WITH(time_of_impact(scene), Catch::Contains("\"left\" and \"right\"") && Catch::Contains("0.5"));
  CHECK(time_of_distance(scene, 0.25).at_start);

  // The left one began sooner, where it was still apart.
  scene.bodies[0].X_WB.p_WB.x() = -4;
  scene.bodies[0].velocity.v_WBcm.x() = 4;
  scene.motion->start_times = {0, 1};
  CHECK_THROWS_WITH(time_of_impact(scene), Catch::Contains("0.5 m"));
}

TEST_CASE("Any unit of length") {
  Dice dice(7);
  const Scene scene = ballistic_pair(dice, 8);
  const TimeOfImpactTruth metres = time_of_impact(scene);
  REQUIRE(metres.status == Status::hit);
  for (const int k : {-400, -100, 100, 400}) {
    Scene scaled = scene;
    scaled.gravity *= std::ldexp(1, k);
    for (Body& b : scaled.bodies) {
      for (Vec3& v : std::get<Polytope>(b.shape).vertices) v *= std::ldexp(1, k);
      b.X_WB.p_WB *= std::ldexp(1, k);
      b.velocity.v_WBcm *= std::ldexp(1, k);
    }
    const TimeOfImpactTruth units = time_of_impact(scaled);
    CAPTURE(k);
    CHECK(units.status == Status::hit);
    CHECK(std::max(units.time.lo, metres.time.lo) <= std::min(units.time.hi, metres.time.hi));
    CHECK(units.time.hi - units.time.lo < 1e-13);
  }
}

TEST_CASE("Parts of a compound: the first to meet") {
  Compound dumbbell;
  for (const double x : {-2.0, 2.0}) dumbbell.parts.push_back({{Vec3(x, 0, 0), {}}, Sphere{1}});
  dumbbell.parts.push_back({{}, Box{Vec3(2, 0.25, 0.25)}});
  Scene scene = pair(body(dumbbell, Vec3(0, 0, 8)), body(Box{Vec3(0.5, 0.5, 0.5)}));
  scene.bodies[0].velocity.v_WBcm = Vec3(0, 0, -1);
  scene.motion = Motion{.sample_times = {16}};
  const TimeOfImpactTruth bar = time_of_impact(scene);
  CHECK(bar.time.lo <= 7.25);
  CHECK(bar.time.hi >= 7.25);
  scene.bodies[1].X_WB.p_WB.x() = 2;
  const TimeOfImpactTruth bell = time_of_impact(scene);
  CHECK(bell.time.lo <= 6.5);
  CHECK(bell.time.hi >= 6.5);
  CHECK(bell.time.hi - bell.time.lo < 1e-14);
  Compound uneven;
  uneven.parts = {{{Vec3(-4, 0, 0), {}}, Sphere{1}}, {{Vec3(4, 0, 1), {}}, Sphere{1}}};
  scene.bodies[0].shape = uneven;
  scene.bodies[1].shape = Box{Vec3(8, 8, 0.5)};
  scene.bodies[1].X_WB.p_WB = Vec3::Zero();
  const TimeOfImpactTruth first = time_of_impact(scene);
  CHECK(first.time.hi >= 6.5);
  CHECK(first.time.hi - first.time.lo < 1e-13);
}

TEST_CASE("Each body flies from its own start") {
  Scene scene = moving_scene(pair(ball(1, Vec3(-8, 0, 0), Vec3(2, 0, 0)), ball(1, Vec3(8, 0, 0), Vec3(-1, 0, 0))), 8);
  const TimeOfImpactTruth whole = time_of_impact(scene);
  scene.bodies[0].X_WB.p_WB.x() = -4;
  scene.motion->start_times = {2, 0};
  const TimeOfImpactTruth later = time_of_impact(scene);
  for (const TimeOfImpactTruth& truth : {whole, later}) {
    CHECK(truth.status == Status::hit);
    CHECK(truth.time.lo <= 14 / 3.0);
    CHECK(truth.time.hi >= 14 / 3.0 - 1e-15);
    CHECK(truth.time.hi - truth.time.lo < 1e-14);
  }
}

TEST_CASE("A body that has turned so often that its rotation is not known, by the time at which the other starts") {
  Body plank = body(Box{{1, 2, 3}}, Vec3(8, 0, 0));
  plank.velocity = {Vec3(-1, 0, 0), Vec3(1e100, 1e99, 1e98)};
  Scene scene = moving_scene(pair(plank, body(Box{{1, 2, 3}}, Vec3::Zero())), 32);
  scene.motion->start_times = {0, 16};
  const TimeOfImpactTruth truth = time_of_impact(scene);
  CHECK(truth.status == Status::undecided);
  CHECK(truth.time.lo == 16);
}

TEST_CASE("The time of a distance comes before that of an impact") {
  Scene scene = moving_scene(pair(ball(1, Vec3(-8, 0, 0), Vec3(2, 0, 0)), ball(1, Vec3(8, 0, 0), Vec3::Zero())), 8);
  const TimeOfImpactTruth near = time_of_distance(scene, 2);
  CHECK(near.time.lo <= 6);
  CHECK(near.time.hi >= 6);
  CHECK(near.time.hi - near.time.lo < 1e-14);
}

TEST_CASE("A push is felt for the whole flight") {
  Scene scene = moving_scene(pair(ball(1, Vec3(-8, 0, 0), Vec3::Zero()), ball(1, Vec3(8, 0, 0), Vec3::Zero())), 8);
  scene.bodies[0].mass = round_mass(2);
  scene.motion->force_bound = 8;
  scene.motion->forces = {{0, 0, Vec3(8, 0, 0)}};
  const TimeOfImpactTruth truth = time_of_impact(scene);
  CHECK(truth.time.lo <= std::sqrt(7.0));
  CHECK(truth.time.hi >= std::sqrt(7.0) * (1 - 1e-15));
  scene.motion->forces.push_back({1, 0, Vec3::Zero()});
  CHECK_THROWS_AS(time_of_impact(scene), InputError);
}

}  // namespace
}  // namespace touchstone::tests
