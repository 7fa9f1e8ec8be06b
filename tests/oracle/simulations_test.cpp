// Each adapter that steps a simulation, on motions with known answers: units, frames, which point a velocity refers to,
// how the materials of a pair combine. The bound is loose, since engines' steps are long and their errors are for the
// properties to detect.
#include "oracle/process/pipe.h"
#include "tests/catch.h"
#include "tests/oracle/built_subjects.h"

namespace touchstone::oracle {
namespace {

Body ball(const Vec3& p_WB, const Vec3& v_WBcm, double e, double mu) {
  Body made;
  made.shape = Sphere{0.5};
  made.X_WB.p_WB = p_WB;
  made.velocity.v_WBcm = v_WBcm;
  made.material = {e, mu};
  return made;
}

/// A table with its top at z = 0.
Body table() {
  Body made;
  made.shape = Box{{20, 20, 1}};
  made.X_WB.p_WB = {0, 0, -1};
  made.mass = Fixed{};
  made.material = {1, 0.5};
  return made;
}

Scene motion_scene(std::vector<Body> bodies, const Vec3& gravity, double time) {
  Scene scene;
  scene.bodies = std::move(bodies);
  scene.gravity = gravity;
  scene.motion = Motion{{time}};
  return scene;
}

void expect(const Scene& scene, const Vec3& p_WB, const Velocity& velocity, const std::string& passed_over = "") {
  int answered = 0;
  for (const auto& subject : answering("simulation")) {
    const std::string& name = subject->card().name;
    if (name == passed_over) continue;
    CAPTURE(name);
    const Answer<Trajectory> answer = subject->simulation(scene);
    if (std::holds_alternative<Abstains>(answer)) continue;
    REQUIRE(std::holds_alternative<Trajectory>(answer));
    const auto& [states, events, complete_until, gave_up, solver] = std::get<Trajectory>(answer);
    if (complete_until) continue;  // the reference stops at rest, and reports that
    REQUIRE(states.size() == scene.motion->sample_times.size());
    REQUIRE(states.back().size() == scene.bodies.size());
    ++answered;
    const auto near = [](const Vec3& a, const Vec3& b) { return (a - b).norm() <= 0.05; };
    CHECK(near(states.back()[0].X_WB.p_WB, p_WB));
    CHECK(near(states.back()[0].velocity.v_WBcm, velocity.v_WBcm));
    CHECK(near(states.back()[0].velocity.w_WB, velocity.w_WB));
  }
  CHECK(answered > 0);
}

TEST_CASE("oracle: simulation: a body falls, pushed from half a second on") {
  Scene scene = motion_scene({ball({1, 2, 3}, {1, 0, 0}, 0, 0)}, {0, 0, -8}, 1);
  scene.bodies[0].mass = MassProperties{2, Vec3::Zero(), Mat3::Identity()};
  scene.motion->force_bound = 4;
  scene.motion->forces = {AppliedForce{0.5, 0, {0, 4, 0}}};
  expect(scene, {2, 2.25, -1}, {{1, 1, -8}, {0, 0, 0}});
}

// A rotation by a quarter turn about the centre of mass, which is 1 m to the right of the body's origin. The origin
// ends 1 m below the centre of mass.
TEST_CASE("oracle: simulation: a body turns about its centre of mass") {
  Scene scene = motion_scene({ball({0, 0, 0}, {0, 0, 0}, 0, 0)}, {0, 0, 0}, 1);
  scene.bodies[0].mass = MassProperties{2, {1, 0, 0}, Vec3(1, 2, 2).asDiagonal()};
  scene.bodies[0].velocity.w_WB = {0, 0, 1.5707963267948966};
  expect(scene, {1, -1, 0}, scene.bodies[0].velocity);
}

// The same, with principal axes that differ from the body's axes.
TEST_CASE("oracle: simulation: inertia that is not diagonal") {
  Scene scene = motion_scene({ball({0, 0, 0}, {0, 0, 0}, 0, 0)}, {0, 0, 0}, 1);
  Mat3 I;
  I << 2, 1, 0, 1, 2, 0, 0, 0, 3;
  scene.bodies[0].mass = MassProperties{2, {1, 0, 0}, I};
  scene.bodies[0].velocity.w_WB = {0, 0, 1.5707963267948966};
  expect(scene, {1, -1, 0}, scene.bodies[0].velocity);
}

// Sliding from 7 m/s with mu = 1/4, the lesser of the two: the ball rolls at 5/7 of that speed after 2·7/(7·2) s.
TEST_CASE("oracle: simulation: a ball slides until it rolls") {
  expect(motion_scene({ball({0, 0, 0.5}, {7, 0, 0}, 0, 0.25), table()}, {0, 0, -8}, 1.25), {7.25, 0, 0.5},
         {{5, 0, 0}, {0, 10, 0}});
}

// Dropped from 1 m, the ball lands at 4 m/s after 1/2 s, and leaves at e = 1/2 of that, the lesser of the two. Bullet
// with default settings restores nothing in steps as short as these.
TEST_CASE("oracle: simulation: a ball bounces") {
  expect(motion_scene({ball({0, 0, 1.5}, {0, 0, 0}, 0.5, 0.25), table()}, {0, 0, -8}, 0.75), {0, 0, 0.75},
         {{0, 0, 0}, {0, 0, 0}}, "bullet.simulation");
}

// The ball slides first, then rolls. The expected numbers were computed by a separate program from Coulomb's law and
// the equations of rigid bodies in steps of 1e-6 s.
TEST_CASE("oracle: simulation: a ball on a turning table") {
  Scene scene = motion_scene({ball({2, 0, 0.5}, {0, 0, 0}, 0, 1), table()}, {0, 0, -8}, 1);
  scene.bodies[1].velocity.w_WB = {0, 0, 1};
  expect(scene, {1.9246, 0.5441, 0.5}, {{-0.1555, 0.5499, 0}, {2.7494, 0.7773, 0}});
}

// dWorldQuickStep takes constraints in an order of random numbers, and here comes to other bits if they go on from the
// question before.
TEST_CASE("oracle: simulation: ODE gives the same answer to the same question") {
  Body box;
  box.shape = Box{{1, 0.5, 0.25}};
  box.X_WB = {{0, 0, 0.75}, {1, 0.125, 0.25, 0}};
  const Scene scene = motion_scene({box, table()}, {0, 0, -8}, 1);
  for (const auto& subject : answering("simulation")) {
    const std::string& name = subject->card().name;
    if (!name.starts_with("ode.")) continue;
    CAPTURE(name);
    const Answer<Trajectory> first = subject->simulation(scene);
    REQUIRE(std::holds_alternative<Trajectory>(first));
    CHECK(std::get<Trajectory>(first) == std::get<Trajectory>(subject->simulation(scene)));
  }
}

}  // namespace
}  // namespace touchstone::oracle
