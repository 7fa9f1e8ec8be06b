// The time stepper against the exact ball, and against textbook results for blocks and stacks.
#include "fast/constraint.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "model/input_error.h"
#include "reference/constraint.h"
#include "tests/catch.h"

namespace touchstone {
namespace {

constexpr double g = 9.75;

Body table(const Vec3& half_extents, const Vec3& place, const Material& material) {
  return {"table", Box{half_extents}, {place, {}}, {}, material, Fixed{}};
}

Scene ball_on_table(const Vec3& v, const Vec3& w, double until) {
  Scene scene;
  scene.gravity = Vec3(0, 0, -g);
  scene.bodies = {{"ball", Sphere{0.25}, {Vec3(0, 0, 0.25), {}}, {v, w}, {1, 1}, Density{}},
                  table(Vec3(2, 2, 1), Vec3(0, 0, -1), {0, 0.125}),
                  table(Vec3(50, 50, 1), Vec3(0, 0, -4), {0, 1})};
  scene.motion = Motion{.sample_times = {until}};
  return scene;
}

double off(const Trajectory& said, const reference::ConstraintTruth& truth) {
  const Vec3& p = said.states.back()[0].X_WB.p_WB;
  double worst = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    worst = std::max(worst, std::abs(p[static_cast<Eigen::Index>(i)] - truth.states.back().p_WB[i].lo));
  }
  return worst;
}

TEST_CASE("constraint: the error goes with the step") {
  for (const auto& [v, w, until] :
       {std::tuple(Vec3(1, 0, 0), Vec3(0, 0, 0), 1.0), std::tuple(Vec3(1, 0.5, 0), Vec3(-8, 3, 3), 1.0),
        std::tuple(Vec3(3.5, 0, 0), Vec3(0, 14, 0), 2.0)}) {
    const Scene scene = ball_on_table(v, w, until);
    const reference::ConstraintTruth truth = reference::constraint(scene);
    // The worse of two steps: where the ball leaves the edge exactly at a step's end, there is no error at all.
    const auto worse = [&](double step) {
      return std::max(off(fast::constrained(scene, {.step = step}), truth),
                      off(fast::constrained(scene, {.step = step / 2}), truth));
    };
    const double coarse = worse(until / 250), fine = worse(until / 4000);
    CHECK(coarse < 0.03);
    CHECK(fine < coarse / 8);
  }
}

// A cube on a slope of atan(3/4); one of its edges is level.
Scene cube_on_slope(double mu) {
  Scene scene;
  scene.gravity = Vec3(0, 0, -g);
  const Quaternion tilt{3, 0, -1, 0};
  scene.bodies = {{"cube", Box{Vec3(0.5, 0.5, 0.5)}, {1.5 * Vec3(-0.6, 0, 0.8), tilt}, {}, {0, mu}, Density{}},
                  {"slope", Box{Vec3(8, 8, 1)}, {Vec3::Zero(), tilt}, {}, {0, 10}, Fixed{}}};
  scene.bodies[0].X_WB.p_WB *= 1 + 0x1p-40;
  scene.motion = Motion{.sample_times = {1.0}};
  return scene;
}

TEST_CASE("constraint: a block stays on a slope that its friction holds, and slides on one that it does not") {
  const Vec3 down(-0.8, 0, -0.6);
  for (const double mu : {0.0, 0.5, 0.74, 0.76, 1.0}) {
    const Scene scene = cube_on_slope(mu);
    const Trajectory said = fast::constrained(scene, {.step = 1.0 / 1024});
    const State& end = said.states.back()[0];
    const double went = (end.X_WB.p_WB - scene.bodies[0].X_WB.p_WB).dot(down);
    const double expected = std::max(0.0, g * (0.6 - mu * 0.8) / 2);
    CHECK(std::abs(went - expected) < 0.01);
    if (mu > 0.75) CHECK(std::abs(went) < 1e-8);
    CHECK(end.velocity.w_WB.norm() < 1e-6);
  }
}

TEST_CASE("constraint: stacks stand, also with a hundredfold and a millionfold mass on top") {
  for (const double heavy : {1.0, 100.0, 1e6}) {
    Scene scene;
    scene.gravity = Vec3(0, 0, -g);
    scene.bodies = {table(Vec3(4, 4, 1), Vec3(0, 0, -1), {0, 0.5})};
    for (int i = 0; i < 3; ++i) {
      scene.bodies.push_back({"box",
                              Box{Vec3(0.5, 0.5, 0.25)},
                              {Vec3(0.0625 * i, 0, 0.25 + 0.5 * i), {}},
                              {},
                              {0, 0.5},
                              Density{i == 2 ? heavy : 1.0}});
    }
    scene.motion = Motion{.sample_times = {2.0}};
    const Trajectory said = fast::constrained(scene, {.step = 1.0 / 512});
    for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
      const Vec3 went = said.states.back()[i].X_WB.p_WB - scene.bodies[i].X_WB.p_WB;
      CHECK(went.norm() < 1e-6);
    }
    CHECK(said.events->size() <= 12);
  }
}

long count(const Trajectory& said, Event::Kind kind) { return std::ranges::count(*said.events, kind, &Event::kind); }

TEST_CASE("constraint: a ball that has bounced its last stays in contact: it is told once") {
  Scene scene = ball_on_table(Vec3::Zero(), Vec3::Zero(), 3.0);
  scene.bodies[0].X_WB.p_WB.z() += 0.5;
  scene.bodies[0].material.restitution = scene.bodies[1].material.restitution = 0.5;
  const Trajectory said = fast::constrained(scene);
  CHECK(count(said, Event::Kind::impact) >= 5);
  CHECK(count(said, Event::Kind::contact) == 1);
  CHECK(count(said, Event::Kind::release) == 0);
}

TEST_CASE("constraint: pushes on the way are told, where they begin to act") {
  Scene scene = ball_on_table(Vec3::Zero(), Vec3::Zero(), 1.0);
  scene.gravity.setZero();
  scene.bodies.resize(1);
  scene.motion->force_bound = 8;
  scene.motion->forces = {{0, 0, {0, 0, 1}}, {0.5, 0, {0, 1, 0}}, {2, 0, {1, 0, 0}}};
  const Trajectory said = fast::constrained(scene, {.step = 1.0 / 256});
  REQUIRE(said.events->size() == 1);
  const Event& push = said.events->front();
  CHECK(push.kind == Event::Kind::force);
  CHECK(push.time == 0.5);
  CHECK(push.after_a.velocity.v_WBcm.z() > 0);
  CHECK(push.after_a.velocity.v_WBcm.y() == 0);
}

/// A ball and a box that collide, with nothing else.
Scene collision_without_table() {
  Scene scene;
  scene.bodies = {{"ball", Sphere{0.5}, {Vec3(-1, 0.125, 0.0625), {}}, {Vec3(2, 0, 0), Vec3(0, 3, 1)}, {0.5, 0.5}, {}},
                  {"box",
                   Box{Vec3(0.25, 0.5, 0.75)},
                   {Vec3(1, 0, 0), {3, 1, 0, -1}},
                   {Vec3(-1, 0, 0), Vec3(0.5, 0, -0.5)},
                   {0.75, 0.25},
                   {}}};
  for (Body& body : scene.bodies) body.mass = Density{2};
  scene.motion = Motion{.sample_times = {0.25, 0.5, 1.0}};
  return scene;
}

TEST_CASE("constraint: impulses are opposite: momentum changes by weight and forces alone") {
  Scene scene = collision_without_table();
  scene.gravity = Vec3(0, 1, -g);
  scene.motion->force_bound = 8;
  scene.motion->forces = {{0, 0, {0, 0, 4}}, {0.375, 1, {0, 4, 0}}, {0.75, 0, {0, 0, -8}}};
  const double step = 1.0 / 1024;
  const Trajectory said = fast::constrained(scene, {.step = step});
  REQUIRE(count(said, Event::Kind::impact) > 0);
  const double m[] = {2 * 4 * 3.14159265358979 / 3 / 8, 2 * 0.75};
  Vec3 first = Vec3::Zero();
  for (std::size_t i = 0; i < 2; ++i) first += m[i] * scene.bodies[i].velocity.v_WBcm;
  const Vec3 of_forces[] = {Vec3(0, 0, 1), Vec3(0, 0.5, 2), Vec3(0, 2.5, 1)};
  for (std::size_t k = 0; k < 3; ++k) {
    Vec3 now = Vec3::Zero();
    for (std::size_t i = 0; i < 2; ++i) now += m[i] * said.states[k][i].velocity.v_WBcm;
    const Vec3 expected = first + (m[0] + m[1]) * scene.motion->sample_times[k] * scene.gravity + of_forces[k];
    CHECK((now - expected).norm() < 1e-12 + 16 * step);  // each force begins up to a step late
  }
}

TEST_CASE("constraint: impulses act at one point: angular momentum stays, but for the step") {
  const Scene scene = collision_without_table();
  const auto angular = [&](const std::vector<State>& states) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < 2; ++i) {
      const double m = i == 0 ? 2 * 4 * 3.14159265358979 / 3 / 8 : 2 * 0.75;
      const Quaternion& q = states[i].X_WB.q_WB;
      const Mat3 R = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
      const Vec3 h(0.25, 0.5, 0.75);
      const Vec3 moments = i == 0 ? Vec3(Vec3::Constant(0.4 * 0.25)) : Vec3((h.squaredNorm() - h.array().square()) / 3);
      sum += m * (states[i].X_WB.p_WB.cross(states[i].velocity.v_WBcm) +
                  R * moments.cwiseProduct(R.transpose() * states[i].velocity.w_WB));
    }
    return sum;
  };
  std::vector<State> start;
  for (const Body& body : scene.bodies) start.push_back({body.X_WB, body.velocity});
  const Trajectory said = fast::constrained(scene, {.step = 1.0 / 4096});
  for (const std::vector<State>& states : said.states) CHECK((angular(states) - angular(start)).norm() < 0.005);
}

// Spun about its axis, a needle rotates by more than a radian in a step; about this axis an angular momentum has 2¹⁷
// times the energy of one about the others. Twice the kinetic energy is L·ω.
TEST_CASE("constraint: a needle that nothing touches keeps its energy, however fast it turns in a step") {
  Scene scene;
  scene.bodies = {{"needle",
                   Box{Vec3(1, 0x1p-9, 0x1p-9)},
                   {Vec3(0, 0, 2), {3, 1, -2, 1}},
                   {Vec3(0, 0, 0), Vec3(512, 256, 64)},
                   {1, 0},
                   MassProperties{1, Vec3::Zero(), Vec3(0x1p-18, 0.5, 0.5).asDiagonal()}}};
  scene.motion = Motion{.sample_times = {1.0}};
  const auto energy = [](const State& state) {
    const Quaternion& q = state.X_WB.q_WB;
    const Vec3 w = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().conjugate() * state.velocity.w_WB;
    return w.dot(Vec3(0x1p-18, 0.5, 0.5).cwiseProduct(w)) / 2;
  };
  const double before = energy({scene.bodies[0].X_WB, scene.bodies[0].velocity});
  const double after = energy(fast::constrained(scene, {.step = 1.0 / 256}).states.back()[0]);
  CHECK(std::abs(after - before) < 1e-9 * before);
}

}  // namespace
}  // namespace touchstone
