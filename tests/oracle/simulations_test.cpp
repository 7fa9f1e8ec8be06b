// Each adapter that steps, on flights whose truth is on paper: units, frames, which point moves with a velocity, how
// two materials make a pair's. The bound is loose: engines' steps are long, and what they lose is for the properties to
// find.
#include <algorithm>

#include "oracle/pipe.h"
#include "tests/catch.h"

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

/// Its top is z = 0.
Body table() {
  Body made;
  made.shape = Box{{20, 20, 1}};
  made.X_WB.p_WB = {0, 0, -1};
  made.mass = Fixed{};
  made.material = {1, 0.5};
  return made;
}

Scene flight(std::vector<Body> bodies, const Vec3& gravity, double time) {
  Scene scene;
  scene.bodies = std::move(bodies);
  scene.gravity = gravity;
  scene.flight = Flight{{time}};
  return scene;
}

void expect(const Scene& scene, const Vec3& p_WB, const Velocity& velocity, const std::string& passed_over = "") {
  int answered = 0;
  for (const std::string& name : subjects_beside(TOUCHSTONE_SUBJECTS)) {
    const std::unique_ptr<Subject> subject = connect(name, TOUCHSTONE_SUBJECTS);
    if (std::ranges::count(subject->card().answers, "simulation") == 0 || name == passed_over) continue;
    CAPTURE(name);
    const Answer<Trajectory> answer = subject->simulation(scene);
    if (std::holds_alternative<Abstains>(answer)) continue;
    REQUIRE(std::holds_alternative<Trajectory>(answer));
    const auto& [states, events, complete_until, gave_up] = std::get<Trajectory>(answer);
    if (complete_until) continue;  // the reference does not follow what rests, and says so
    REQUIRE(states.size() == scene.flight->times.size());
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
  Scene scene = flight({ball({1, 2, 3}, {1, 0, 0}, 0, 0)}, {0, 0, -8}, 1);
  scene.bodies[0].mass = MassProperties{2, Vec3::Zero(), Mat3::Identity()};
  scene.flight->force_bound = 4;
  scene.flight->pushes = {Push{0.5, 0, {0, 4, 0}}};
  expect(scene, {2, 2.25, -1}, {{1, 1, -8}, {0, 0, 0}});
}

// A quarter of a turn about the centre of mass, 1 m to the right of the body's origin, which ends 1 m below it.
TEST_CASE("oracle: simulation: a body turns about its centre of mass") {
  Scene scene = flight({ball({0, 0, 0}, {0, 0, 0}, 0, 0)}, {0, 0, 0}, 1);
  scene.bodies[0].mass = MassProperties{2, {1, 0, 0}, Vec3(1, 2, 2).asDiagonal()};
  scene.bodies[0].velocity.w_WB = {0, 0, 1.5707963267948966};
  expect(scene, {1, -1, 0}, scene.bodies[0].velocity);
}

// The same, with principal axes that are not the body's.
TEST_CASE("oracle: simulation: inertia that is not diagonal") {
  Scene scene = flight({ball({0, 0, 0}, {0, 0, 0}, 0, 0)}, {0, 0, 0}, 1);
  Mat3 I;
  I << 2, 1, 0, 1, 2, 0, 0, 0, 3;
  scene.bodies[0].mass = MassProperties{2, {1, 0, 0}, I};
  scene.bodies[0].velocity.w_WB = {0, 0, 1.5707963267948966};
  expect(scene, {1, -1, 0}, scene.bodies[0].velocity);
}

// From 7 m/s by mu = 1/4, the lesser of the two: it rolls at 5/7 of that after 2·7/(7·2) s.
TEST_CASE("oracle: simulation: a ball slides until it rolls") {
  expect(flight({ball({0, 0, 0.5}, {7, 0, 0}, 0, 0.25), table()}, {0, 0, -8}, 1.25), {7.25, 0, 0.5},
         {{5, 0, 0}, {0, 10, 0}});
}

// From 1 m up it lands at 4 m/s after 1/2 s, and leaves at e = 1/2 of that, the lesser of the two. Bullet, as shipped,
// restores nothing in steps as short as these.
TEST_CASE("oracle: simulation: a ball bounces") {
  expect(flight({ball({0, 0, 1.5}, {0, 0, 0}, 0.5, 0.25), table()}, {0, 0, -8}, 0.75), {0, 0, 0.75},
         {{0, 0, 0}, {0, 0, 0}}, "bullet.simulation");
}

// It slides at first, then rolls. The numbers: Coulomb's law and rigid bodies' in steps of 1e-6 s, by another program.
TEST_CASE("oracle: simulation: a ball on a turning table") {
  Scene scene = flight({ball({2, 0, 0.5}, {0, 0, 0}, 0, 1), table()}, {0, 0, -8}, 1);
  scene.bodies[1].velocity.w_WB = {0, 0, 1};
  expect(scene, {1.9246, 0.5441, 0.5}, {{-0.1555, 0.5499, 0}, {2.7494, 0.7773, 0}});
}

}  // namespace
}  // namespace touchstone::oracle
