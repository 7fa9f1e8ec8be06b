// Piles of many cubes: what statics says stands does not move by a bit, and what it says falls does, as computed.
#include <algorithm>
#include <cmath>

#include "tests/catch.h"
#include "tests/fast/simulation/scenes.h"

namespace touchstone::fast {
namespace {

constexpr double g = 10, envelope = 0x1p-31;  // 2⁻³⁰ of half a side
const Material material{0, 0.5};

Body cube(double x, double z) { return brick(Vec3::Constant(0.5), Vec3(x, 0, z), material); }

/// Cubes of side 1 on a table, each `step` farther along x than the one below.
Scene leaning_stack(int count, double step) {
  std::vector<Body> bodies{table()};
  for (int i = 0; i < count; ++i) bodies.push_back(cube(step * i, i + 0.5));
  return moving_scene(bodies, {0, 0, -g}, {0.25, 0.5, 0.75, 1});
}

/// Rows of cubes, each of one cube less than the one below and over the gaps between its cubes.
Scene pyramid(int rows) {
  std::vector<Body> bodies{table()};
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < rows - row; ++i) bodies.push_back(cube((i + row / 2.0) * 1.0625, row + 0.5));
  }
  return moving_scene(bodies, {0, 0, -g}, {1, 1000});
}

void check_stands(const Scene& scene) {
  const Simulated done = simulate(scene);
  REQUIRE(!done.stopped);
  CHECK(done.statistics.contact_steps == 0);
  for (const std::vector<State>& states : done.trajectory.states) {
    for (std::size_t i = 0; i < states.size(); ++i)
      CHECK(states[i] == State{scene.bodies[i].X_WB, scene.bodies[i].velocity});
  }
}

double energy(const std::vector<State>& states) {
  double sum = 0;
  for (std::size_t i = 1; i < states.size(); ++i) {
    const Velocity& V = states[i].velocity;
    sum += V.v_WBcm.squaredNorm() / 2 + V.w_WB.squaredNorm() / 12 + g * states[i].X_WB.p_WB.z();
  }
  return sum;
}

/// How far the centre of the uppermost cube has moved after t, if all but the lowest tip about the edge of that as one
/// body: a pendulum that starts at rest, its centre beyond the edge.
double tipped(int count, double step, double t) {
  double inertia = 0, beyond = 0, height = 0;
  const int tip = count - 1;
  for (int i = 0; i < tip; ++i) {
    const double x = step * (i + 1) - 0.5, z = i + 0.5;
    inertia += 1.0 / 6 + x * x + z * z;
    beyond += x;
    height += z;
  }
  const double rate = std::sqrt(g * height / inertia);
  const double angle = beyond / height * (std::cosh(rate * t) - 1);
  return angle * std::hypot(step * tip - 0.5, tip - 0.5);
}

TEST_CASE("pile: stacks of 17, 50 and 100 cubes stand, and so does a pyramid of 36, for ever") {
  for (const int count : {17, 50, 100}) check_stands(leaning_stack(count, 0));
  check_stands(pyramid(8));
}

// The limit is 1/n, see sparse/balance_test.cpp.
TEST_CASE("pile: a leaning stack of n cubes stands up to a step of 1/n") {
  check_stands(leaning_stack(3, 0.3333));
  check_stands(leaning_stack(10, 0.0999));
  check_stands(leaning_stack(50, 0.0199));
}

TEST_CASE("pile: beyond a step of 1/n it tips as a pendulum does, and no energy comes from nowhere") {
  const auto check = [](int count, double step) {
    const Scene scene = leaning_stack(count, step);
    const Simulated done = simulate(scene);
    REQUIRE(!done.stopped);
    CHECK(done.statistics.deepest < envelope);
    std::vector<State> start;
    for (const Body& body : scene.bodies) start.push_back({body.X_WB, body.velocity});
    double before = energy(start);
    for (const std::vector<State>& states : done.trajectory.states) {
      const double now = energy(states);
      CHECK(now <= before + 2 * count * g * envelope);  // docs/spec/simulation.md grants twice the envelope's height
      before = now;
    }
    const double moved = (done.trajectory.states.back().back().X_WB.p_WB - start.back().X_WB.p_WB).norm();
    // The pendulum's equation is linear in the angle, of which there is less than 10⁻³; a step errs by less.
    CHECK(moved == Approx(tipped(count, step, 1)).epsilon(2e-3));
  };
  check(3, 0.3334);
  check(10, 0.1001);
  check(30, 0.0335);
}

// Struck beside its middle, the cubes of a stack tilt by 10⁻⁷: their faces are nearly parallel, and corners of one hang
// over sides of the next. A step of theirs may be 7 ms long. When rounding chose the normal of such faces, most steps
// were 0.1 µs long; when corners that hang over a side hid those of the face below, cubes sank into each other.
TEST_CASE("pile: a stack that a ball strikes takes steps of usual length, and no cube sinks into another") {
  for (const int count : {8, 12}) {
    Scene scene = leaning_stack(count, 0);
    Body ball = scene.bodies.back();
    ball.shape = Sphere{0.5};
    ball.X_WB.p_WB += Vec3(0.25, 0, 1.25);
    ball.velocity.v_WBcm = {0, 0, -1};
    scene.bodies.push_back(ball);
    scene.motion->sample_times = {0.5};
    const Simulated done = simulate(scene);
    REQUIRE(!done.stopped);
    CHECK(done.statistics.contact_steps < 250);
    CHECK(done.statistics.deepest < 1e-9);  // of a side: what piles must keep
  }
}

// The beam presses on the other post, so friction holds that one. Where the step did not end with the slip, the other
// post was left with 2 mm/s, tilted and sank into the table.
TEST_CASE("pile: a post that slides under the beam that it carries stops, and the other post has not moved") {
  const Vec3 half(0.5, 1, 0.75);
  Body post = brick(half, Vec3(2, 0, half.z()), material), other = brick(half, Vec3(-2, 0, half.z()), material);
  post.mass = MassProperties{4, Vec3::Zero(), 20 * Mat3::Identity()};
  post.velocity.v_WBcm = {1, 1, 0};
  Body beam = brick(Vec3(3, 0.5, 0.25), Vec3(0, 0, 1.75), material);
  beam.mass = MassProperties{64, Vec3::Zero(), 256 * Mat3::Identity()};
  const Simulated done = simulate(moving_scene({table(), other, post, beam}, {0, 0, -8}, {0.25}));
  REQUIRE(!done.stopped);
  const std::vector<State>& after = done.trajectory.states.back();
  for (const State& state : after) CHECK(state.velocity.v_WBcm.norm() + state.velocity.w_WB.norm() < 1e-9);
  CHECK((after[1].X_WB.p_WB - other.X_WB.p_WB).norm() < 1e-9);
  CHECK(std::abs(after[3].X_WB.p_WB.z() - beam.X_WB.p_WB.z()) < 1e-9);
}

}  // namespace
}  // namespace touchstone::fast
