// Long steps of a lone ball beside short ones and beside closed forms.
#include "fast/constraint/stepper.h"

#include <Eigen/Geometry>
#include <cmath>

#include "fast/mark.h"
#include "tests/catch.h"

namespace touchstone::fast::constraint {
namespace {

constexpr double g = 9.75;
constexpr int steps = 4096;

Body block(const Vec3& half_extents, const Vec3& place, double friction) {
  return {"block", Box{half_extents}, {place, {}}, {}, {0, friction}, Fixed{}};
}

Scene one_ball(const Vec3& p, const Velocity& velocity) {
  Scene scene;
  scene.gravity = Vec3(0, 0, -g);
  scene.bodies = {{"ball", Sphere{0.25}, {p, {}}, velocity, {0, 1}, Density{}}};
  scene.motion = Motion{.sample_times = {1.0}};
  return scene;
}

struct Followed {
  State ball;
  std::vector<Event> events;
  std::uint64_t long_steps = 0, sweeps = 0;
};

Followed follow(const Scene& scene) {
  const MarkCounts before = mark_counts;
  Stepper stepper(scene, 1.0 / steps, 200);
  stepper.advance(0, 1, steps);
  const MarkCounts since = marks_since(before);
  return {stepper.states()[0], stepper.events(), since[static_cast<std::size_t>(Mark::step_long)],
          since[static_cast<std::size_t>(Mark::contact_sweep)]};
}

/// The same scene with a body far away that moves, so that no ball is alone and all steps are short.
Followed follow_by_short_steps(Scene scene) {
  scene.bodies.push_back({"other", Sphere{0.25}, {Vec3(0, 0, 1000), {}}, {}, {0, 1}, Density{}});
  const Followed followed = follow(scene);
  CHECK(followed.long_steps == 0);
  return followed;
}

double angle_between(const State& a, const State& b) {
  const auto rotation = [](const Quaternion& q) { return Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized(); };
  return rotation(a.X_WB.q_WB).angularDistance(rotation(b.X_WB.q_WB));
}

TEST_CASE(
    "time stepper: a lone ball that touches nothing takes a few long steps along its parabola, and turns steadily") {
  const Velocity start{Vec3(1, 2, 3), Vec3(0, 0, 5)};
  const Followed free = follow(one_ball(Vec3::Zero(), start));
  CHECK(free.long_steps > 0);
  CHECK(free.long_steps < 32);
  CHECK((free.ball.X_WB.p_WB - Vec3(1, 2, 3 - g / 2)).norm() < 1e-13);
  CHECK((free.ball.velocity.v_WBcm - Vec3(1, 2, 3 - g)).norm() < 1e-13);
  CHECK(angle_between(free.ball, {{Vec3::Zero(), {std::cos(2.5), 0, 0, std::sin(2.5)}}, {}}) < 1e-7);
}

// Slip stops after v/(μ g (1 + 1/κ)) = 2 v/(7 μ g), κ = 2/5, and 5/7 of the velocity is left.
TEST_CASE("time stepper: a lone ball slides until it rolls, and the change is found to a short step") {
  const double mu = 0.125, v = 1, t = 2 * v / (7 * mu * g);
  Scene scene = one_ball(Vec3(0, 0, 0.25), {Vec3(v, 0, 0), Vec3::Zero()});
  scene.bodies.push_back(block(Vec3(4, 4, 1), Vec3(0, 0, -1), mu));
  const Followed followed = follow(scene);
  CHECK(followed.long_steps > 0);
  CHECK(followed.sweeps < 200);
  CHECK(std::abs(followed.ball.X_WB.p_WB.x() - (v * t - mu * g * t * t / 2 + 5 * v / 7 * (1 - t))) <
        mu * g * 2 / steps);  // the wrong acceleration for two short steps
  CHECK(std::abs(followed.ball.velocity.v_WBcm.x() - 5 * v / 7) < mu * g * 2 / steps);
  REQUIRE(followed.events.size() == 2);  // contact, and the end of slip
  CHECK(std::abs(followed.events[1].time - t) < 2.0 / steps);
}

// With sidespin ω changes its direction while the ball slides.
TEST_CASE("time stepper: long steps turn a lone ball at least as accurately as short ones") {
  const auto scene_of = [](double friction, double spin) {
    Scene scene = one_ball(Vec3(0, 0, 0.25), {Vec3(8, 0, 0), Vec3(0, 0, spin)});
    scene.bodies.push_back(block(Vec3(50, 50, 1), Vec3(0, 0, -1), friction));
    return scene;
  };
  for (const auto& [mu, spin] : {std::pair(0.03125, 12.0), std::pair(0.125, 12.0), std::pair(0.03125, 100.0)}) {
    const Scene scene = scene_of(mu, spin);
    const Followed followed = follow(scene);
    CHECK(followed.long_steps > 0);
    // ω = (0, α t, spin), α = μ g r/(κ r²), by the midpoint rule in 2²⁰ steps.
    const double alpha = mu * g / (0.4 * 0.25), h = 0x1p-20;
    Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
    for (int i = 0; i < 1 << 20; ++i) {
      const Vec3 w(0, alpha * h * (i + 0.5), spin);
      q = Eigen::Quaterniond(Eigen::AngleAxisd(h * w.norm(), w.normalized())) * q;
    }
    const State truth{{Vec3::Zero(), {q.w(), q.x(), q.y(), q.z()}}, {}};
    const double error = angle_between(followed.ball, truth);
    CHECK(error < alpha / (2 * steps));  // of short steps, which neglect the change of ω in each
    CHECK(error < angle_between(follow_by_short_steps(scene).ball, truth) + 1e-7);
  }
}

// The ball passes over the far edge of a block whose top is 1 below its start, or just misses that edge.
TEST_CASE("time stepper: long steps overlook no corner on the way") {
  for (const double beyond : {-0.2, -0.01, 0.0, 0.01, 0.2}) {
    CAPTURE(beyond);
    const double fall = std::sqrt(2 / g);  // for the height of 1
    Scene scene = one_ball(Vec3(-4 * fall + beyond, 0, 1.25), {Vec3(4, 0, 0), Vec3::Zero()});
    scene.bodies.push_back(block(Vec3(4, 4, 1), Vec3(-4, 0, -1), 0.5));
    const Followed followed = follow(scene), shortly = follow_by_short_steps(scene);
    CHECK(followed.long_steps > 0);
    REQUIRE(followed.events.size() == shortly.events.size());
    for (std::size_t i = 0; i < followed.events.size(); ++i) {
      CHECK(followed.events[i].kind == shortly.events[i].kind);
      CHECK(std::abs(followed.events[i].time - shortly.events[i].time) < 3.0 / steps);
    }
    CHECK((followed.ball.X_WB.p_WB - shortly.ball.X_WB.p_WB).norm() < 0.01);
  }
}

// Thrown up under a ceiling, the ball meets it, or turns back below it, within what could be one long step.
TEST_CASE("time stepper: long steps overlook no ceiling that a ball meets and leaves again") {
  for (const double clear : {-0x1p-10, 0x1p-10}) {
    Scene scene = one_ball(Vec3::Zero(), {Vec3(0, 0, g / 2), Vec3::Zero()});  // at the apex after half a second
    scene.bodies.push_back(block(Vec3(1, 1, 1), Vec3(0, 0, g / 8 + 0.25 + 1 + clear), 0.5));
    const Followed followed = follow(scene);
    CHECK(followed.long_steps > 0);
    CHECK(followed.events.empty() == (clear > 0));
  }
}

// Nothing else is near, so at the start no boxes overlap.
TEST_CASE("time stepper: long steps overlook no thin plate that is still far away") {
  const double x = 7.25 - 0x1p-8 - 0.25, t = x / 16;  // where and when the ball meets it
  Scene scene = one_ball(Vec3::Zero(), {Vec3(16, 0, 0), Vec3::Zero()});
  scene.bodies.push_back(block(Vec3(0x1p-8, 0.25, 0.25), Vec3(7.25, 0, -g * t * t / 2), 0.5));
  const Followed followed = follow(scene);
  CHECK(followed.long_steps > 0);
  REQUIRE_FALSE(followed.events.empty());
  CHECK(followed.events[0].kind == Event::Kind::impact);
  CHECK(std::abs(followed.events[0].time - t) < 2.0 / steps);
}

// At the edge the normal turns, so a long step would go on along the face.
TEST_CASE("time stepper: a lone ball that rolls off a face is followed by short steps at its edge") {
  Scene scene = one_ball(Vec3(0, 0, 0.25), {Vec3(2, 0, 0), Vec3(0, 8, 0)});
  scene.bodies.push_back(block(Vec3(1, 1, 1), Vec3(0, 0, -1), 0.5));
  const Followed followed = follow(scene), shortly = follow_by_short_steps(scene);
  CHECK(followed.long_steps > 0);
  REQUIRE(followed.events.size() == 2);  // contact and release
  CHECK(std::abs(followed.events[1].time - 0.5) < 3.0 / steps);
  CHECK((followed.ball.X_WB.p_WB - shortly.ball.X_WB.p_WB).norm() < 0.01);
}

TEST_CASE("time stepper: no ball is alone beside a body that moves, under applied forces, or with its weight aside") {
  const Scene ball = one_ball(Vec3::Zero(), {});
  CHECK(follow(ball).long_steps > 0);
  follow_by_short_steps(ball);
  Scene pushed = ball, aside = ball, box = ball, carried = ball;
  pushed.motion->force_bound = 1;
  pushed.motion->forces = {{0.5, 0, {1, 0, 0}}};
  aside.bodies[0].mass = MassProperties{1, Vec3(0.125, 0, 0), Mat3::Identity()};
  box.bodies[0].shape = Box{Vec3(1, 1, 1)};
  carried.bodies.push_back(block(Vec3(1, 1, 1), Vec3(0, 0, -8), 0.5));
  carried.bodies[1].velocity.v_WBcm = Vec3(1, 0, 0);
  for (const Scene& scene : {pushed, aside, box, carried}) CHECK(follow(scene).long_steps == 0);
}

// Not rounding, which bounced in nearly each step where nothing but a force is a measure of what presses.
TEST_CASE("time stepper: a crate that a force alone presses onto a floor lies still") {
  Scene scene = one_ball(Vec3(0, 0, 0.2), {});
  scene.gravity = Vec3::Zero();
  scene.bodies[0].shape = Box{Vec3(0.5, 0.3, 0.2)};
  scene.bodies[0].material = {0.5, 0.5};
  scene.bodies.push_back(block(Vec3(5, 5, 0.5), Vec3(0, 0, -0.5), 0.5));
  scene.bodies[1].material.restitution = 0.5;
  scene.motion->force_bound = 400;
  scene.motion->forces = {{0, 0, {20, 3, -300}}};
  const MarkCounts before = mark_counts;
  const Followed followed = follow(scene);
  CHECK(marks_since(before)[static_cast<std::size_t>(Mark::step_bounce)] == 0);
  CHECK(followed.events.size() <= 2);
  CHECK((followed.ball.X_WB.p_WB - Vec3(0, 0, 0.2)).norm() < 1e-9);
}

}  // namespace
}  // namespace touchstone::fast::constraint
