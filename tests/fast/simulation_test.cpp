// Simulations with known solutions, and the laws of the simulation.
#include "fast/simulation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "app/motion/motion_scenes.h"
#include "fast/lin_canny/parting_normals.h"
#include "fast/lin_canny/rotation.h"
#include "fast/lin_canny/solid.h"
#include "model/input_error.h"
#include "tests/catch.h"
#include "tests/fast/simulation/scenes.h"

namespace touchstone::fast {
namespace {

using Kind = Event::Kind;
const Vec3 down(0, 0, -10);

const State& last(const Simulated& done) { return done.trajectory.states.back()[0]; }

TEST_CASE("a bouncing ball rises to e² of its height, and its bounces end when the series says") {
  for (const double e : {0.5, 0.9}) {
    const Scene scene = moving_scene({ball(0.5, Vec3(0, 0, 1.5), Vec3::Zero(), {e, 0}), table()}, down, {20});
    const Simulated done = simulate(scene);
    const std::vector<Event> bounces = of_kind(done, Kind::impact);
    REQUIRE(bounces.size() > 10);
    double speed = std::sqrt(20.0), time = std::sqrt(0.2);
    for (const Event& bounce : bounces) {
      CHECK(std::abs(bounce.time - time) < 1e-12);  // the last micro-bounces are slow: 1e-15 m take 1e-12 s
      speed *= e;
      CHECK(std::abs(bounce.after_a.velocity.v_WBcm.z() - speed) < 1e-12);
      time += speed / 5;
    }
    const std::vector<Event> completed = of_kind(done, Kind::completed);
    REQUIRE(completed.size() == 1);
    CHECK(std::abs(completed[0].time - std::sqrt(0.2) * (1 + e) / (1 - e)) < 1e-12);
    CHECK(last(done).velocity.v_WBcm == Vec3::Zero());
    CHECK(std::abs(last(done).X_WB.p_WB.z() - 0.5) < 1e-14);
  }
}

TEST_CASE("49 balls bounce for 20 s and keep their energy") {
  std::vector<Body> bodies;
  for (int i = 0; i < 49; ++i) {
    bodies.push_back(ball(0.5, Vec3(2 * (i % 7), 2 * (i / 7), 1.5 + 0.1 * i), Vec3::Zero(), {1, 0.5}));
  }
  bodies.push_back(table());
  const Scene scene = moving_scene(bodies, down, {1, 5, 10, 20});
  const Simulated done = simulate(scene);
  double worst = 0;
  for (const std::vector<State>& states : done.trajectory.states) {
    for (std::size_t i = 0; i < 49; ++i) {
      const double energy = states[i].velocity.v_WBcm.squaredNorm() / 2 + 10 * states[i].X_WB.p_WB.z();
      worst = std::max(worst, std::abs(energy - 10 * bodies[i].X_WB.p_WB.z()));
    }
  }
  CHECK(worst < 1e-12);
  CHECK(done.statistics.of(Kind::impact) > 49 * 10);
}

TEST_CASE("a ball that slides rolls after 2v/7μg, at 5v/7") {
  const Scene scene = moving_scene({ball(0.5, Vec3(0, 0, 0.5), Vec3(7, 0, 0), {0.5, 0.2}), table()}, down, {1, 3});
  const Simulated done = simulate(scene);
  const State& at_1 = done.trajectory.states[0][0];
  CHECK(std::abs(at_1.X_WB.p_WB.x() - 6) < 1e-14);
  CHECK(std::abs(at_1.velocity.v_WBcm.x() - 5) < 1e-14);
  CHECK(std::abs(last(done).X_WB.p_WB.x() - 16) < 4e-14);
  CHECK(std::abs(last(done).velocity.w_WB.y() - 10) < 1e-13);
  CHECK(done.trajectory.events->size() == 2);
}

TEST_CASE("down a ramp a ball rolls while tan α ≤ 7μ/2, else it slips") {
  const Vec3 acceleration(10 * 0.28, 0, -10 * 0.96);
  for (const double mu : {0.2, 0.05}) {
    const Scene scene = moving_scene({ball(0.5, Vec3(0, 0, 0.5), Vec3::Zero(), {0, mu}), table()}, acceleration, {2});
    const Simulated done = simulate(scene);
    const double a = mu == 0.2 ? 5.0 / 7 * 2.8 : 2.8 - mu * 9.6;
    CHECK(std::abs(last(done).X_WB.p_WB.x() - 2 * a) < 1e-14 * 4);
  }
}

TEST_CASE("a brick stays on a ramp up to the angle of friction, and slides beyond") {
  const Vec3 acceleration(10 * 0.28, 0, -10 * 0.96);  // tan α = 0.29167
  const double just_more = 0.2917, just_less = 0.2916;
  const Simulated stays = simulate(
      moving_scene({brick(Vec3(0.5, 0.5, 0.5), Vec3(0, 0, 0.5), {0.3, just_more}), table()}, acceleration, {10}));
  CHECK(last(stays).X_WB.p_WB == Vec3(0, 0, 0.5));
  CHECK(stays.trajectory.events->size() == 1);
  const Simulated slides = simulate(
      moving_scene({brick(Vec3(0.5, 0.5, 0.5), Vec3(0, 0, 0.5), {0.3, just_less}), table()}, acceleration, {10}));
  CHECK(std::abs(last(slides).X_WB.p_WB.x() - 50 * (2.8 - just_less * 9.6)) < 1e-12);
}

TEST_CASE("a brick that slides on a table stops after v²/2μg") {
  Scene scene = moving_scene({brick(Vec3(0.5, 0.4, 0.3), Vec3(0, 0, 0.3), {0.3, 0.5}), table()}, down, {5});
  scene.bodies[0].velocity.v_WBcm = Vec3(3, 4, 0);
  const Simulated done = simulate(scene);
  CHECK((last(done).X_WB.p_WB - Vec3(1.5, 2, 0.3)).norm() < 1e-14);
  CHECK(last(done).velocity == Velocity{});
  CHECK(std::abs(done.trajectory.events->back().time - 1) < 1e-15);
}

TEST_CASE("a brick that falls on its corner comes to rest, and is never in the table") {
  Scene scene = moving_scene({brick(Vec3(0.5, 0.4, 0.3), Vec3(0, 0, 1), {0.2, 0.8}), table()}, down, {3});
  scene.bodies[0].X_WB.q_WB = {0.9, 0.3, 0.2, 0.1};
  const Simulated done = simulate(scene);
  REQUIRE(!done.stopped);
  CHECK(last(done).velocity == Velocity{});
  CHECK(done.statistics.of(Kind::contact) + done.statistics.of(Kind::completed) > 0);
  const double loss = done.statistics.loss + done.statistics.contact_loss, height = 1 - last(done).X_WB.p_WB.z();
  CHECK(std::abs(loss / (0.48 * 10 * height) - 1) < 1e-2);  // the rest is lost in resting contact
}

/// A ball that rolls without slip on a turning table, with the speed that keeps it on a circle of radius 1.
Scene turntable(double envelope) {
  const double turn = 2, v = turn * 2 / 7;
  Scene scene = moving_scene({ball(0.5, Vec3(1, 0, 0.5), Vec3(0, v, 0), {0.3, 1}), table(5)}, down, {1});
  scene.bodies[0].velocity.w_WB = Vec3(2 * (turn - v), 0, 0);
  scene.bodies[1].velocity.w_WB = Vec3(0, 0, turn);
  scene.motion->envelope = envelope;
  return scene;
}

const Vec3 on_the_turntable(0.84112921341523592, 0.54083421335883185, 0.5);  // cos 4/7, sin 4/7

TEST_CASE("micro-bounces may stand for contact: a ball on a turntable circles at 2/7 of its rate") {
  const auto error = [&](double envelope) {
    const Simulated done = simulate(turntable(envelope), {.micro_collisions = true});
    CHECK(done.statistics.of(Kind::micro_collision) > 1000);
    return (last(done).X_WB.p_WB - on_the_turntable).head<2>().norm();
  };
  const double at_1e_7 = error(1e-7), at_1e_9 = error(1e-9);  // found: 4.5e-9, 4.5e-11: as the bounces' height
  CHECK(at_1e_7 < 2e-8);
  CHECK(at_1e_9 < 2e-10);
}

TEST_CASE("where no closed form is known steps in contact are of second order, and nothing sinks") {
  const auto error = [&](double steps) {
    const Simulated done = simulate(turntable(1e-9), {.contact_steps = steps});
    CHECK(done.statistics.of(Kind::micro_collision) == 0);
    CHECK(done.statistics.contact_steps > static_cast<std::int64_t>(steps));
    CHECK(std::abs(last(done).X_WB.p_WB.z() - 0.5) < 1e-14);
    return (last(done).X_WB.p_WB - on_the_turntable).head<2>().norm();
  };
  const double coarse = error(16), fine = error(32);
  CHECK(coarse < 1e-5);
  CHECK(std::abs(coarse / fine - 4) < 0.1);
}

/// A cube of 1 kg and sides of 1 m on one edge, tilted about y by 2 atan 0.15, that slips on the table while it falls.
Scene cube_on_an_edge() {
  Scene scene = moving_scene({brick(Vec3(0.5, 0.5, 0.5), Vec3::Zero(), {0, 0.25}), table()}, down, {0.1875});
  scene.bodies[0].X_WB.q_WB = {1, 0, 0.15, 0};
  scene.bodies[0].X_WB.p_WB.z() = 0.5 * (1 - 0.15 * 0.15 + 2 * 0.15) / (1 + 0.15 * 0.15);
  return scene;
}

/// x, z, the angle about y and their rates of a cube that slips towards +x on an edge, r = (r_x, r_z) from its centre:
/// N (1/m + r_x (r_x + μ r_z)/I) = g + w² r_z, since the edge has no acceleration along z, and friction is −μ N.
using Planar = Eigen::Matrix<double, 6, 1>;

Eigen::Vector2d edge_of(const Planar& at) {
  const double c = std::cos(at[2]), s = std::sin(at[2]);
  return {0.5 * (c - s), -0.5 * (c + s)};
}

Planar rate(const Planar& at) {
  const double mu = 0.25, I = 1.0 / 6, w = at[5];
  const Eigen::Vector2d r = edge_of(at);
  const double N = (10 + w * w * r[1]) / (1 + r[0] * (r[0] + mu * r[1]) / I);
  Planar rates;
  rates << at[3], at[4], w, -mu * N, N - 10, (-mu * N * r[1] - N * r[0]) / I;
  return rates;
}

/// By the classical method of Runge and Kutta, in 4096 steps.
Planar slipped(Planar at, double seconds) {
  const double h = seconds / 4096;
  for (int i = 0; i < 4096; ++i) {
    const Planar a = rate(at), b = rate(at + h / 2 * a), c = rate(at + h / 2 * b), d = rate(at + h * c);
    at += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return at;
}

TEST_CASE("a cube that slips on an edge while it turns: steps are of second order") {
  const Scene scene = cube_on_an_edge();
  Planar start = Planar::Zero();
  start[1] = scene.bodies[0].X_WB.p_WB.z();
  start[2] = 2 * std::atan(0.15);
  const Planar end = slipped(start, 0.1875);
  REQUIRE(end[3] + end[5] * edge_of(end)[1] > 0.1);  // it still slips towards +x
  REQUIRE(end[2] > 0.1);                             // and is not flat yet
  const auto error = [&](double steps) {
    const State state = last(simulate(scene, {.contact_steps = steps}));
    return Vec3(state.X_WB.p_WB - Vec3(end[0], 0, end[1])).norm();
  };
  const double coarse = error(16), fine = error(32);
  CHECK(coarse < 1e-4);
  CHECK(std::abs(coarse / fine - 4) < 0.4);
}

/// Its centre of mass is a quarter of the radius below its centre.
Scene rocking_ball() {
  Scene scene = moving_scene({ball(1, Vec3(0, 0, 1), Vec3::Zero(), {0, 1}), table()}, down, {0.5, 1, 2, 4});
  scene.bodies[0].mass = MassProperties{1, Vec3(0, 0, -0.25), 0.375 * Mat3::Identity()};
  scene.bodies[0].X_WB.q_WB = {4, 0, 1, 0};
  return scene;
}

TEST_CASE("a ball whose mass is off its centre rocks and keeps its energy, but for what steps may not make") {
  const Scene scene = rocking_ball();
  const auto energy = [&](const State& state) {
    const Vec3 c = state.X_WB.p_WB + lin_canny::rotation(state.X_WB.q_WB) * Vec3(0, 0, -0.25);
    const Velocity& v = state.velocity;
    return v.v_WBcm.squaredNorm() / 2 + 0.375 * v.w_WB.squaredNorm() / 2 + 10 * c.z();
  };
  double before = energy({scene.bodies[0].X_WB, scene.bodies[0].velocity});
  const double first = before;
  const Simulated done = simulate(scene);
  CHECK(done.statistics.deepest < 1e-12);
  for (const std::vector<State>& states : done.trajectory.states) {
    const double now = energy(states[0]);
    CHECK(now <= before + 1e-11);
    CHECK(std::abs(now / first - 1) < 1e-6);
    CHECK(std::abs(states[0].X_WB.p_WB.z() - 1) < 1e-12);
    before = now;
  }
}

/// A compound of balls with their centres on an arc of radius 1, 1/16 rad apart.
Scene bow_of_balls() {
  Compound bow;
  for (int k = -8; k <= 8; ++k) {
    const double angle = k / 16.0;
    bow.parts.push_back({{Vec3(std::sin(angle), 0, 1 - std::cos(angle)), {}}, Sphere{0.5}});
  }
  Scene scene = moving_scene({ball(0.5, Vec3(0, 0, 0.5), Vec3::Zero(), {0, 1}), table()}, down, {});
  scene.bodies[0].shape = bow;
  scene.bodies[0].mass = MassProperties{1, Vec3::Zero(), Mat3::Identity()};
  scene.bodies[0].velocity = {Vec3(0.5, 0, 0), Vec3(0, 1, 0)};
  for (int sample = 1; sample <= 64; ++sample) scene.motion->sample_times.push_back(sample / 16.0);
  return scene;
}

TEST_CASE("a bow of balls rocks from ball to ball, and none of them is ever in the table") {
  const Scene scene = bow_of_balls();
  const Simulated done = simulate(scene);
  CHECK(done.statistics.of(Kind::impact) > 10);
  double most = 0;
  for (const std::vector<State>& states : done.trajectory.states) {
    const Mat3 R = lin_canny::rotation(states[0].X_WB.q_WB);
    for (const Part& part : std::get<Compound>(scene.bodies[0].shape).parts) {
      CHECK((states[0].X_WB.p_WB + R * part.X_BP.p_WB).z() > 0.5 - 1e-9);
    }
    most = std::max(most, std::abs(std::asin(R(0, 2))));
  }
  CHECK(most > 0.2);
}

TEST_CASE("who leaves the ground is said to leave it where he stood") {
  Scene scene = bow_of_balls();
  scene.motion->forces = {{0.25, 0, Vec3(0, 0, 32)}};
  const Vec3 place(5, 7, 3);
  for (Body& body : scene.bodies) body.X_WB.p_WB += place;
  const Trajectory answer = simulate(scene).trajectory;
  const auto left = std::ranges::find(*answer.events, Kind::release, &Event::kind);
  REQUIRE(left != answer.events->end());
  CHECK(std::abs((left->p_WC - place).z()) < 1e-6);
  CHECK((left->p_WC - place).norm() < 1);
}

TEST_CASE("a rattleback of balls turns back as a smooth one does") {
  const auto& all = app::motion_scenes();
  const auto known = std::ranges::find(all, "rattleback", [](const auto& motion) { return motion.scene.name; });
  const Trajectory answer = simulate(known->scene).trajectory;
  CHECK(known->error(answer) < 0.04);
  CHECK(answer.states.back()[0].velocity.w_WB.z() < -1);
}

TEST_CASE("a brick that spins about its middle axis turns over and keeps energy and angular momentum") {
  Scene scene =
      moving_scene({brick(Vec3(0.5, 0.3, 0.1), Vec3::Zero(), {})}, Vec3::Zero(), {1, 4.5, 4.75, 5, 5.25, 5.5, 20});
  scene.bodies[0].velocity.w_WB = Vec3(1e-6, 5, 1e-6);
  scene.bodies[0].mass = MassProperties{1, Vec3::Zero(), Vec3(0.1, 0.26, 0.34).asDiagonal()};
  scene.bodies.push_back(ball(0.5, Vec3(5, 0, 0), Vec3::Zero(), {}));
  bool over = false;
  const Simulated done = simulate(scene);
  for (const std::vector<State>& states : done.trajectory.states) {
    const Mat3 R = lin_canny::rotation(states[0].X_WB.q_WB);
    const Vec3 w = R.transpose() * states[0].velocity.w_WB, L = Vec3(0.1, 0.26, 0.34).cwiseProduct(w);
    CHECK(std::abs(w.dot(L) - 6.5) < 1e-11);
    CHECK((R * L - Vec3(1e-7, 1.3, 3.4e-7)).norm() < 1e-11);
    over = over || w.y() < 4;
  }
  CHECK(over);
}

TEST_CASE("bricks in a box, without friction and loss, keep their energy") {
  std::vector<Body> bodies;
  for (int i = 0; i < 8; ++i) {
    bodies.push_back(brick(Vec3(0.2, 0.15, 0.1), Vec3(i % 2, i / 2 % 2, i / 4) * 0.8, {1, 0}));
    bodies.back().X_WB.q_WB = {1, 0.1 * i, 0.3, -0.05 * i};
    bodies.back().velocity = {Vec3(0.3 * (i % 2) - 0.2, 0.2 * (i % 5) - 0.4, 0.1), Vec3(1, i % 4, 2 - i % 7)};
  }
  for (int wall = 0; wall < 6; ++wall) {
    Vec3 half = Vec3::Constant(3), p = Vec3::Constant(0.4);
    half[wall % 3] = 0.5;
    p[wall % 3] = wall < 3 ? -1 : 1.8;
    bodies.push_back(brick(half, p, {1, 0}));
    bodies.back().mass = Fixed{};
  }
  const Scene scene = moving_scene(bodies, Vec3::Zero(), {5});
  const Simulated done = simulate(scene);
  CHECK(done.statistics.of(Kind::impact) > 50);
  CHECK(std::abs(done.statistics.loss) < 1e-14);
  CHECK(simulate(scene).trajectory == done.trajectory);
}

Body brick_at(double z, double density) {
  Body body = brick(Vec3(0.5, 0.5, 0.5), Vec3(0, 0, z), {0.3, 0.5});
  body.mass = Density{density};
  return body;
}

TEST_CASE("a stack stands: forces that balance it are found, and nothing moves by a bit, nor costs a step") {
  for (const double ratio : {1.0, 100.0, 1e6}) {
    const Scene scene =
        moving_scene({brick_at(0.5, 1), brick_at(1.5, 1), brick_at(2.5, ratio), table()}, down, {1, 1000});
    const Simulated done = simulate(scene);
    REQUIRE(!done.stopped);
    CHECK(done.statistics.contact_steps == 0);
    CHECK(done.statistics.of(Kind::impact) + done.statistics.of(Kind::micro_collision) == 0);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(done.trajectory.states.back()[i] == State{scene.bodies[i].X_WB, scene.bodies[i].velocity});
    }
  }
}

TEST_CASE("a stack that is pushed goes, and what leans too far falls") {
  Scene pushed = moving_scene({brick_at(0.5, 1), brick_at(1.5, 1), table()}, down, {0.875});
  pushed.motion->force_bound = 8;
  pushed.motion->forces = {{0.5, 1, Vec3(8, 0, 0)}};  // weight 10 N, μ = 1/2: 3 m/s²
  const Simulated slid = simulate(pushed);
  CHECK(std::abs(slid.trajectory.states.back()[1].X_WB.p_WB.x() - 0.2109375) < 1e-11);
  CHECK((slid.trajectory.states.back()[0].X_WB.p_WB - pushed.bodies[0].X_WB.p_WB).norm() < 1e-11);

  Scene leaning = moving_scene({brick_at(0.5, 1), brick_at(1.5, 1), table()}, down, {1});
  leaning.bodies[1].X_WB.p_WB.x() = 0.625;  // its centre of mass is beyond the edge
  CHECK(simulate(leaning).trajectory.states.back()[1].X_WB.p_WB.z() < 1.25);
}

TEST_CASE("micro-bounces may stand for a stack: until there are too many, and it says so") {
  const Scene scene = moving_scene({brick_at(0.5, 1), brick_at(1.5, 1), table()}, down, {1});
  const Simulated done = simulate(scene, {.micro_collisions = true, .most_micro_bounces = 1000});
  REQUIRE(done.stopped);
  CHECK_THAT(done.stopped->why, Catch::Contains("micro-bounces"));
  CHECK(done.trajectory.complete_until == done.stopped->time);
}

TEST_CASE("a simulation that takes more work than allowed ends, at the same time whatever ran before") {
  const Scene scene = moving_scene({ball(0.5, Vec3(0, 0, 1), Vec3::Zero(), {1, 0}), table()}, down, {100});
  const SimulationOptions options{.most_work_per_body = 20'000};
  const Simulated done = simulate(scene, options), again = simulate(scene, options);
  REQUIRE(done.stopped);
  CHECK(done.stopped->why == "more work than allowed");
  CHECK(done.stopped->time > 1);
  CHECK(again.stopped->time == done.stopped->time);
}

TEST_CASE("a cradle hands its speed on") {
  std::vector<Body> bodies;
  for (int i = 0; i < 5; ++i) {
    bodies.push_back(ball(0.5, Vec3(1.25 * i, 0, 0), Vec3(i == 0 ? 1 : 0, 0, 0), {1, 0}));
  }
  const Simulated done = simulate(moving_scene(bodies, Vec3::Zero(), {4}));
  CHECK(done.statistics.of(Kind::impact) == 4);
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(done.trajectory.states[0][i].velocity.v_WBcm == Vec3(i == 4 ? 1 : 0, 0, 0));
  }
}

TEST_CASE("a million to one: the light ball goes to and fro and the heavy one keeps its momentum's worth") {
  const Scene scene =
      moving_scene({ball(0.5, Vec3(0, 0, 0), Vec3(1, 0, 0), {1, 0}, 1e6),
                    ball(0.5, Vec3(3, 0, 0), Vec3::Zero(), {1, 0}), brick(Vec3(1, 5, 5), Vec3(10, 0, 0), {1, 0})},
                   Vec3::Zero(), {9});
  Scene walled = scene;
  walled.bodies[2].mass = Fixed{};
  const Simulated done = simulate(walled);
  CHECK(std::abs(kinetic(walled, done.trajectory.states.back()) / kinetic(walled) - 1) < 1e-12);
  CHECK(done.statistics.of(Kind::impact) > 1000);
}

TEST_CASE("a rough ball turns what it loses into spin") {
  const Scene scene = moving_scene({ball(0.5, Vec3(0, 0, 1), Vec3(7, 0, -5), {1, 10}), table()}, Vec3::Zero(), {0.2});
  const Simulated done = simulate(scene);
  const State& after = last(done);
  CHECK(std::abs(after.velocity.v_WBcm.x() - 5) < 1e-14);
  CHECK(std::abs(after.velocity.w_WB.y() - 10) < 1e-13);
  CHECK(after.velocity.v_WBcm.z() == 5);
}

TEST_CASE("a ball that spins faster than doubles can tell stays as it is turned") {
  for (const double spin : {1e22, 1e30, 1e150}) {
    Scene scene = moving_scene({ball(0.5, Vec3(0, 0, 5), Vec3::Zero(), {1, 0})}, down, {1});
    scene.bodies[0].velocity.w_WB = Vec3(spin, 0, 0);
    const Simulated done = simulate(scene);
    CHECK(last(done).X_WB.p_WB == Vec3(0, 0, 0));
    CHECK(last(done).X_WB.q_WB == scene.bodies[0].X_WB.q_WB);
  }
}

TEST_CASE("an elastic gas keeps its energy, and its total momentum to the bit if asked") {
  const Scene scene = gas(5, {1, 0});
  const Simulated done = simulate(scene);
  CHECK(done.statistics.of(Kind::impact) > 200);
  CHECK(std::abs(kinetic(scene, done.trajectory.states.back()) / kinetic(scene) - 1) < 1e-13);

  Scene open = scene;
  open.bodies.resize(125);
  const Simulated exact = simulate(open, {.exact_momentum = true});
  CHECK(exact.statistics.of(Kind::impact) > 50);
  Vec3 before = Vec3::Zero(), after = Vec3::Zero();
  for (std::size_t i = 0; i < 125; ++i) {
    before += exact.momentum_before[i];
    after += exact.momentum[i];
    CHECK((exact.trajectory.states.back()[i].velocity.v_WBcm - exact.momentum[i]).norm() < 0x1p-45);  // masses are 1
  }
  CHECK(after == before);
  CHECK(exact.momentum != exact.momentum_before);
}

TEST_CASE("neither frames nor strangers change a bit") {
  const Scene scene = gas(4, {0.9, 0.3});
  const Trajectory as_is = simulate(scene).trajectory;
  CHECK(simulate(scene, {.frame = 0.01}).trajectory == as_is);
  CHECK(simulate(scene, {.frame = 0.25}).trajectory == as_is);

  Scene more = scene;
  for (int i = 0; i < 20; ++i) more.bodies.push_back(ball(0.1, Vec3(50 + i, 0, 0), Vec3(0, 1, 0), {1, 0}));
  more.bodies.push_back(brick(Vec3(1, 2, 3), Vec3(0, 50, 0), {}));
  more.bodies.back().velocity.w_WB = Vec3(1, 2, 3);
  Simulated done = simulate(more);
  done.trajectory.states.back().resize(scene.bodies.size());
  CHECK(done.trajectory.states == as_is.states);
}

/// Bricks stacked on each other, and one that falls on them.
Scene pile(const std::vector<double>& heights, double beside, const Material& material, double until) {
  std::vector<Body> bodies{table(8)};
  for (const double z : heights) bodies.push_back(brick(Vec3(0.5, 0.5, 0.5), Vec3(0, 0, z), material));
  bodies.back().X_WB.p_WB.x() = beside;
  return moving_scene(bodies, down, {until});
}

TEST_CASE("groups that strike at one time change no bit of each other") {
  const Scene one = pile({0.5, 1.5, 2.5, 4}, 0.25, {0, 0.5}, 0.5);
  Scene two = one;
  for (Body& body : two.bodies) body.X_WB.p_WB.y() += 64;
  two.bodies.insert(two.bodies.end(), one.bodies.begin(), one.bodies.end());
  const Trajectory alone = simulate(one).trajectory;
  CHECK(alone.events->size() > 20);
  const Simulated both = simulate(two);
  REQUIRE(!both.stopped);
  const std::vector<State>& last = both.trajectory.states.back();
  CHECK(std::vector<State>(last.begin() + 5, last.end()) == alone.states.back());
}

/// The separation of two boxes along the direction of greatest separation (m); < 0: they overlap.
double gap(const Body& a, const State& at_a, const Body& b, const State& at_b) {
  const lin_canny::Solid A(a.shape), B(b.shape);
  const lin_canny::PosedHull in_A = lin_canny::posed_hull(A.parts()[0], lin_canny::CachedPose(at_a.X_WB), Vec3::Zero());
  const lin_canny::PosedHull in_B = lin_canny::posed_hull(B.parts()[0], lin_canny::CachedPose(at_b.X_WB), Vec3::Zero());
  const auto least = [](const lin_canny::PosedHull& body, const Vec3& n) {
    double low = std::numeric_limits<double>::infinity();
    for (int v = 0; v < body.hull->vertex_count(); ++v) low = std::min(low, n.dot(body.vertex(v)));
    return low;
  };
  const auto width = [&](const Vec3& n) { return least(in_A, n) + least(in_B, -n); };
  return width(lin_canny::widest_parting_normal(in_A, in_B, width));
}

TEST_CASE("what falls on a pile bounces, rocks and comes down, and nothing sinks") {
  for (const double e : {0.0, 0.5, 0.875, 1.0}) {
    for (const double beside : {0.0, 0.125}) {
      const Scene scene = pile({0.5, 1.5, 2.5, 5}, beside, {e, 0.5}, 0.875);
      CAPTURE(e, beside);
      const Simulated done = simulate(scene);
      REQUIRE(!done.stopped);
      CHECK(done.statistics.of(Kind::impact) >= 7);  // e = 1, flat: down through four contacts, and up through three
      CHECK(done.statistics.deepest < 1e-8);
      for (std::size_t i = 0; i < 4; ++i) {
        CHECK(gap(scene.bodies[i + 1], done.trajectory.states.back()[i + 1], scene.bodies[i],
                  done.trajectory.states.back()[i]) > -1e-8);
      }
    }
  }
}

TEST_CASE("who tumbles, however wildly, strikes where he is said to be") {
  for (const double spin : {100.0, 1e3, 1e4, 1e5}) {
    CAPTURE(spin);
    Scene scene = moving_scene({brick(Vec3(0.5, 0.3, 0.1), Vec3(0, 0, 1.75), {0.5, 0}), table(32)}, down, {1});
    scene.bodies[0].velocity.w_WB = Vec3(spin / 10000, spin, 0);
    const Simulated done = simulate(scene);
    REQUIRE(!done.stopped);
    const std::vector<Event> hits = of_kind(done, Kind::impact);
    REQUIRE(!hits.empty());
    for (const Event& hit : hits) {
      CHECK(std::abs(gap(scene.bodies[0], hit.after_a, scene.bodies[1], hit.after_b)) < 0x1p-30 * 0.1);
    }
  }
}

/// The scene with all lengths multiplied by `unit`, a power of two.
Scene in_units(Scene scene, double unit) {
  for (Body& body : scene.bodies) {
    if (auto* box = std::get_if<Box>(&body.shape)) box->half_extents *= unit;
    if (auto* sphere = std::get_if<Sphere>(&body.shape)) sphere->radius *= unit;
    body.X_WB.p_WB *= unit;
    body.velocity.v_WBcm *= unit;
    if (auto* mass = std::get_if<MassProperties>(&body.mass)) {
      mass->p_BBcm *= unit;
      mass->I_BBcm_B *= unit * unit;
    }
    if (auto* density = std::get_if<Density>(&body.mass)) density->value /= unit * unit * unit;
  }
  scene.gravity *= unit;
  return scene;
}

// A count, since times depend on the machine. Steps that were shortened for a contact took 750.
TEST_CASE("six dominoes take no more than 730 contact steps in a second, and all but a few are solved") {
  const auto& all = app::motion_scenes();
  Scene scene = std::ranges::find(all, "dominoes", [](const auto& motion) { return motion.scene.name; })->scene;
  scene.motion->sample_times = {1};
  const Simulated done = simulate(scene);
  CHECK(!done.stopped);
  CHECK(done.statistics.contact_steps <= 730);
  CHECK(done.statistics.unconverged <= 8);
}

TEST_CASE("what lengths are measured in changes no bit") {
  for (const char* name : {"rocking_ball", "turntable", "dominoes", "pool_break", "needle"}) {
    CAPTURE(name);
    const auto& all = app::motion_scenes();
    const Scene scene = std::ranges::find(all, name, [](const auto& motion) { return motion.scene.name; })->scene;
    const Simulated done = simulate(scene);
    for (const double unit : {0x1p-20, 0x1p20}) {
      CAPTURE(unit);
      const Simulated other = simulate(in_units(scene, unit));
      CHECK(other.statistics.count == done.statistics.count);
      CHECK(other.statistics.contact_steps == done.statistics.contact_steps);
      const std::vector<State>&here = done.trajectory.states.back(), &there = other.trajectory.states.back();
      for (std::size_t i = 0; i < here.size(); ++i) {
        CHECK(there[i].X_WB.p_WB == unit * here[i].X_WB.p_WB);
        CHECK(there[i].X_WB.q_WB == here[i].X_WB.q_WB);
      }
    }
  }
}

TEST_CASE("events come in time order, each pair approaches, and what is reported is flown from") {
  const Scene scene = gas(4, {0.8, 0});
  const Simulated done = simulate(scene);
  struct Segment {
    double since;
    State state;
  };
  std::vector<Segment> segments;
  for (const Body& body : scene.bodies) segments.push_back({0, {body.X_WB, body.velocity}});
  double time = 0;
  for (const Event& event : *done.trajectory.events) {
    CHECK(event.time >= time);
    CHECK(event.a < event.b);
    time = event.time;
    Segment &a = segments[static_cast<std::size_t>(event.a)], &b = segments[static_cast<std::size_t>(event.b)];
    CHECK((a.state.velocity.v_WBcm - b.state.velocity.v_WBcm).dot(event.nhat_BA_W) < 0);
    CHECK(event.after_a.X_WB.p_WB == a.state.X_WB.p_WB + (time - a.since) * a.state.velocity.v_WBcm);
    a = {time, event.after_a};
    b = {time, event.after_b};
  }
}

/// The total momentum, and the angular momentum about the origin.
struct Moments {
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
};

Moments moments(const Scene& scene, const std::vector<State>& states) {
  Moments sum;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto& mass = std::get<MassProperties>(scene.bodies[i].mass);
    const Vec3 P = mass.mass * states[i].velocity.v_WBcm;
    sum.linear += P;
    sum.angular += states[i].X_WB.p_WB.cross(P) + mass.I_BBcm_B(0, 0) * states[i].velocity.w_WB;
  }
  return sum;
}

TEST_CASE("a hundred thousand impacts keep momentum and angular momentum of what is alone") {
  Scene scene = gas(3, {1, 0});
  Compound hollow;
  for (std::size_t wall = 27; wall < 33; ++wall) {
    hollow.parts.push_back({scene.bodies[wall].X_WB, std::get<Box>(scene.bodies[wall].shape)});
    hollow.parts.back().X_BP.p_WB -= Vec3::Constant(0.15);
  }
  scene.bodies.resize(27);
  Body box = ball(1, Vec3::Constant(0.15), Vec3::Zero(), {1, 0});
  box.shape = hollow;
  std::get<MassProperties>(box.mass).mass = 64;
  scene.bodies.push_back(box);
  scene.motion->sample_times = {0, 330};
  const Simulated done = simulate(scene, {.keep_events = false});
  REQUIRE(!done.stopped);
  const auto impacts = static_cast<double>(done.statistics.of(Kind::impact));
  CHECK(impacts > 1e5);
  const Moments before = moments(scene, done.trajectory.states.front());
  const Moments after = moments(scene, done.trajectory.states.back());
  // An impact rounds the momenta of both bodies by 2u, where they are below 1 kg m/s, and positions by 8u.
  CHECK((after.linear - before.linear).norm() < 8 * u * impacts);
  CHECK((after.angular - before.angular).norm() < 64 * u * impacts);
  CHECK((after.angular - before.angular).norm() > 0);
}

TEST_CASE("a push changes the path from its time on, and what then meets is found") {
  Scene scene =
      moving_scene({ball(0.5, Vec3(0, 0, 0), Vec3::Zero(), {1, 0}), ball(0.5, Vec3(5, 0, 0), Vec3::Zero(), {1, 0})},
                   Vec3::Zero(), {10});
  scene.motion->force_bound = 2;
  scene.motion->forces = {{1, 0, Vec3(2, 0, 0)}, {2, 0, Vec3::Zero()}};
  const Simulated done = simulate(scene);  // 2 m/s² for 1 s: 2 m/s after 1 m, then 3 m more
  const std::vector<Event> hits = of_kind(done, Kind::impact);
  REQUIRE(hits.size() == 1);
  CHECK(std::abs(hits[0].time - 3.5) < 2e-14);
  CHECK(done.statistics.of(Kind::force) == 2);
}

TEST_CASE("bad input is named") {
  Scene scene =
      moving_scene({ball(0.5, Vec3(0, 0, 0), Vec3::Zero(), {1, 0}), ball(0.5, Vec3(0.75, 0, 0), Vec3::Zero(), {1, 0})},
                   Vec3::Zero(), {10});
  CHECK_THROWS_WITH(simulate(scene), Catch::Contains("bodies[0]: overlaps bodies[1] at the start by 0.25"));
  scene.gravity = down;
  CHECK_THROWS_AS(simulate(scene, {.exact_momentum = true}), InputError);
  scene.motion.reset();
  CHECK_THROWS_WITH(simulate(scene), Catch::Contains("motion"));
}

TEST_CASE("a simulation that may not go on says where it ended") {
  const Scene scene = moving_scene({ball(0.5, Vec3(0, 0, 1), Vec3::Zero(), {1, 0}), table()}, down, {100});
  const Simulated done = simulate(scene, {.most_events = 10});
  REQUIRE(done.stopped);
  CHECK(done.stopped->a == 0);
  CHECK(done.trajectory.complete_until == done.stopped->time);
}

}  // namespace
}  // namespace touchstone::fast
