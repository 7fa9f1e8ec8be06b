// The exact ball on tables, against what the textbooks say.
#include "reference/constraint.h"

#include <cmath>

#include "model/infinity.h"
#include "model/input_error.h"
#include "tests/catch.h"

namespace touchstone {
namespace {

using reference::BallTruth;
using reference::constraint;
using reference::ConstraintTruth;
using Mode = ConstraintTruth::Mode;
using Kind = Event::Kind;

constexpr double g = 9.75, r = 0.25, mu = 0.125;

Body table(const Vec3& half_extents, const Vec3& place, const Material& material = {0, mu}) {
  return {"table", Box{half_extents}, {place, {}}, {}, material, Fixed{}};
}

// A table whose top is z = 0 under |x|, |y| ≤ 2, and a ball of radius 1/4 on it.
Scene ball_on_table(const Vec3& v, double until) {
  Scene scene;
  scene.gravity = Vec3(0, 0, -g);
  scene.bodies = {{"ball", Sphere{r}, {Vec3(0, 0, r), {}}, {v, Vec3::Zero()}, {1, 1}, Density{}},
                  table(Vec3(2, 2, 1), Vec3(0, 0, -1))};
  scene.motion = Motion{.sample_times = {until / 2, until}};
  return scene;
}

double width(const Interval& i) { return i.hi - i.lo; }
bool holds(const Interval& i, double x, double slack = 1e-14) { return i.lo - slack <= x && x <= i.hi + slack; }

TEST_CASE("constraint: a ball slides, then rolls at 5/7 of its speed") {
  const double v0 = 1, stop = 2 * v0 / (7 * mu * g);
  const ConstraintTruth truth = constraint(ball_on_table(Vec3(v0, 0, 0), 1));
  REQUIRE(truth.changes.size() == 2);
  CHECK(truth.changes[0].kind == Kind::contact);
  CHECK(truth.changes[0].segment.mode == Mode::sliding);
  CHECK(truth.changes[1].segment.mode == Mode::rolling);
  CHECK(holds(truth.changes[1].time, stop));
  CHECK(width(truth.changes[1].time) < 1e-15);
  CHECK(truth.changes[1].rate == Approx(3.5 * mu * g));
  const BallTruth& end = truth.states[1];
  CHECK(holds(end.v_WB[0], 5.0 / 7));
  CHECK(holds(end.w_WB[1], 5.0 / 7 / r));
  CHECK(holds(end.p_WB[0], 12 * v0 * v0 / (49 * mu * g) + 5.0 / 7 * (1 - stop)));
  CHECK(end.p_WB[2] == Interval{r, r});
}

TEST_CASE("constraint: sidespin bends the way, and the spin about the normal stays") {
  Scene scene = ball_on_table(Vec3(1, 0, 0), 0.25);
  scene.bodies[0].velocity.w_WB = Vec3(-8, 0, 3);  // u = v − r w × n = (1, −2, 0) before it stops
  const ConstraintTruth truth = constraint(scene);
  REQUIRE(truth.changes.size() == 1);
  const double u = std::sqrt(5), t = 0.25;
  CHECK(holds(truth.states[1].v_WB[0], 1 - mu * g * t / u));
  CHECK(holds(truth.states[1].v_WB[1], mu * g * t * 2 / u));
  CHECK(truth.states[1].w_WB[2] == Interval{3, 3});
}

TEST_CASE("constraint: a fast ball rolls off the edge and falls to the floor, where it stays") {
  Scene scene = ball_on_table(Vec3(3.5, 0, 0), 2);
  scene.bodies[0].velocity.w_WB = Vec3(0, 14, 0);
  scene.bodies.push_back(table(Vec3(50, 50, 1), Vec3(0, 0, -4), {0, 1}));
  const ConstraintTruth truth = constraint(scene);
  REQUIRE(truth.changes.size() == 4);
  CHECK(truth.first.mode == Mode::rolling);
  CHECK(truth.changes[1].kind == Kind::release);
  CHECK(holds(truth.changes[1].time, 2 / 3.5));
  CHECK(truth.changes[1].rate == Approx(3.5));
  CHECK(truth.changes[2].kind == Kind::impact);
  CHECK(truth.changes[2].other == 2);
  CHECK(holds(truth.changes[2].time, 2 / 3.5 + std::sqrt(2 * 3 / g)));
  CHECK(truth.changes[3].kind == Kind::contact);
  CHECK(truth.changes[3].segment.mode == Mode::rolling);
  CHECK(holds(truth.states[1].v_WB[0], 3.5));
  CHECK(holds(truth.states[1].p_WB[2], r - 3));
  CHECK(holds(truth.states[1].v_WB[2], 0));
}

// Rolling up a table tilted by atan(3/4), at 5k m/s: it turns after (5k)²/(2 · 5/7 · g · 3/5), and the edge is 1/2
// away.
Scene rolls_up(double k) {
  Scene scene;
  scene.gravity = Vec3(0, 0, -g);
  scene.bodies = {
      {"ball", Sphere{0.5}, {Vec3(-0.5, 0, 1.5), {}}, {Vec3(4 * k, 0, 3 * k), Vec3(0, 10 * k, 0)}, {1, 1}, Density{}},
      {"table", Box{Vec3(1, 1, 1)}, {Vec3::Zero(), {3, 0, -1, 0}}, {}, {0, 10}, Fixed{}}};
  scene.motion = Motion{.sample_times = {1.0}};
  return scene;
}

TEST_CASE("constraint: just reaching the edge of a tilted table, and just not") {
  const double critical = std::sqrt(0.5 * 2 * 5.0 / 7 * g * 3 / 5) / 5;
  const double below = std::floor(critical * 0x1p30) / 0x1p30;
  const ConstraintTruth truth = constraint(rolls_up(below));
  CHECK(truth.changes.size() == 1);
  CHECK(truth.first.mode == Mode::rolling);
  CHECK_THROWS_WITH(constraint(rolls_up(below + 0x1p-30)), Catch::Contains("pivots"));
}

TEST_CASE("constraint: obstacles send the ball back, and the smooth ones do not turn it") {
  Scene scene = ball_on_table(Vec3(1, 0, 0), 1);
  scene.bodies[0].velocity.w_WB = Vec3(0, 4, 0);
  scene.bodies.push_back(table(Vec3(0.25, 1, 1), Vec3(1, 0, 1), {0.5, 0}));
  const ConstraintTruth truth = constraint(scene);
  REQUIRE(truth.changes.size() >= 3);
  CHECK(truth.changes[1].kind == Kind::impact);
  CHECK(holds(truth.changes[1].time, 0.5));
  CHECK(holds(truth.changes[1].after.v_WB[0], -0.5));
  CHECK(holds(truth.changes[1].after.w_WB[1], 4));
  CHECK(truth.changes[2].kind == Kind::contact);
  CHECK(truth.changes[2].segment.mode == Mode::sliding);
}

// As above, until exactly when the ball meets the obstacle.
TEST_CASE("constraint: what happens exactly at the end does not count, but comes near") {
  Scene scene = ball_on_table(Vec3(1, 0, 0), 0.5);
  scene.bodies[0].velocity.w_WB = Vec3(0, 4, 0);
  scene.bodies.push_back(table(Vec3(0.25, 1, 1), Vec3(1, 0, 1), {0.5, 0}));
  const ConstraintTruth truth = constraint(scene);
  REQUIRE(truth.changes.size() == 1);        // contact with the table, from the start on
  CHECK(truth.first.clearance == infinity);  // it has no duration
  CHECK(truth.changes[0].segment.clearance <= 0);
  CHECK(truth.changes[0].segment.clearance > -1e-14);
  CHECK(holds(truth.states[1].v_WB[0], 1));
}

TEST_CASE("constraint: a rough obstacle lifts the ball off the table") {
  Scene scene = ball_on_table(Vec3(1, 0, 0), 1);
  scene.bodies[0].velocity.w_WB = Vec3(0, 4, 0);
  scene.bodies.push_back(table(Vec3(0.25, 1, 1), Vec3(1, 0, 1), {0.5, 1}));
  const ConstraintTruth truth = constraint(scene);
  REQUIRE(truth.changes.size() >= 4);
  CHECK(truth.changes[1].kind == Kind::impact);
  CHECK(truth.changes[2].kind == Kind::release);
  // Its front moves down at 1 m/s; friction up to 2/7 stops that: v_z = 2/7.
  CHECK(holds(truth.changes[2].after.v_WB[2], 2.0 / 7));
  CHECK(truth.changes[3].kind == Kind::impact);
  CHECK(truth.changes[3].other == 1);
  CHECK(holds(truth.changes[3].time, 0.5 + 2 * (2.0 / 7) / g));
}

TEST_CASE("constraint: a ball that bounces loses e a bounce") {
  Scene scene = ball_on_table(Vec3(0, 0, 0), 1.25);
  scene.bodies[0].X_WB.p_WB.z() = r + 1;
  scene.bodies[1].material.restitution = 0.5;
  const ConstraintTruth truth = constraint(scene);
  const double fall = std::sqrt(2 / g);
  REQUIRE(truth.changes.size() >= 3);
  CHECK(holds(truth.changes[0].time, fall));
  CHECK(holds(truth.changes[1].time, fall * 2));
  CHECK(holds(truth.changes[2].time, fall * 2.5));
  scene.motion->sample_times = {1.5};  // after fall (1 + e)/(1 − e) it rests
  CHECK_THROWS_WITH(constraint(scene), Catch::Contains("more changes"));
}

// From one bounce to the next enclosures grew by a factor of 40, so far from the origin 10⁻⁵ of an impulse was not
// known.
TEST_CASE("constraint: a ball that bounces without loss, far from the origin, is known to rounding") {
  for (const double turned : {0.0, 0.25}) {
    const double height = 0x1p-6, fall = std::sqrt(2 * height / g), far = 0x1p35;
    Scene scene = ball_on_table(Vec3(0x1p-7, 0, 0), 80 * fall);
    scene.bodies[0].X_WB.p_WB.z() = r + height - far;
    scene.bodies[1].X_WB.p_WB.z() -= far;
    scene.bodies[1].material.restitution = 1;
    scene.bodies[1].X_WB.q_WB = {1, 0, 0, turned};
    const ConstraintTruth truth = constraint(scene);
    CAPTURE(turned);
    REQUIRE(truth.changes.size() == 40);
    const ConstraintTruth::Change& last = truth.changes.back();
    CHECK(holds(last.time, 79 * fall, 1e-12));
    CHECK(width(last.time) < 1e-14);
    CHECK(width(last.after.v_WB[2]) < 1e-15);
    CHECK(holds(last.after.v_WB[2], std::sqrt(2 * g * height)));
  }
}

TEST_CASE("constraint: what is outside says why") {
  const auto refuses = [](const Scene& scene, const std::string& why) {
    CHECK_THROWS_WITH(constraint(scene), Catch::Contains(why));
  };
  Scene slow = ball_on_table(Vec3(1, 0, 0), 4);
  slow.bodies[0].velocity.w_WB = Vec3(0, 4, 0);
  refuses(slow, "pivots");
  Scene two = ball_on_table(Vec3(1, 0, 0), 1);
  two.bodies.push_back(two.bodies[0]);
  refuses(two, "second moving body");
  Scene overlaps = ball_on_table(Vec3(1, 0, 0), 1);
  overlaps.bodies[0].X_WB.p_WB.z() = r - 0x1p-50;
  refuses(overlaps, "overlaps");
  Scene weightless = ball_on_table(Vec3(1, 0, 0), 1);
  weightless.gravity.setZero();
  refuses(weightless, "nothing holds");
  Scene nothing = ball_on_table(Vec3(1, 0, 0), 1);
  nothing.motion.reset();
  refuses(nothing, "motion");
}

}  // namespace
}  // namespace touchstone
