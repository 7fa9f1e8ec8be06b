// Each adapter that answers time_of_impact, on motions with known answers. The bound is loose, since engines' errors
// are for the properties to detect.
#include "oracle/process/pipe.h"
#include "tests/catch.h"
#include "tests/oracle/built_subjects.h"

namespace touchstone::oracle {
namespace {

using Status = TimeOfImpact::Status;

Body body(Shape shape, const Vec3& p_WB, const Velocity& velocity = {}) {
  Body made;
  made.shape = std::move(shape);
  made.X_WB.p_WB = p_WB;
  made.velocity = velocity;
  return made;
}

Scene motion_scene(Body A, Body B, double time) {
  Scene scene;
  scene.bodies = {std::move(A), std::move(B)};
  scene.motion = Motion{{time}};
  return scene;
}

void expect(const Scene& scene, std::optional<double> time, const std::string& passed_over = "") {
  int answered = 0;
  for (const auto& subject : answering("time_of_impact")) {
    const std::string& name = subject->card().name;
    if (name == passed_over) continue;
    CAPTURE(name);
    const Answer<TimeOfImpact> answer = subject->time_of_impact(scene);
    if (std::holds_alternative<Abstains>(answer)) continue;
    REQUIRE(std::holds_alternative<TimeOfImpact>(answer));
    const auto& said = std::get<TimeOfImpact>(answer);
    ++answered;
    CHECK(said.status == (time ? Status::hit : Status::miss));
    if (time) CHECK(std::abs(said.time.value() - *time) < 1e-3);
  }
  CHECK(answered > 0);
}

/// Bullet's GJK cast lets boxes pass through each other.
const std::string blind = "bullet.gjk_cast";

TEST_CASE("oracle: time of impact: boxes on a straight line, falling together") {
  Scene scene =
      motion_scene(body(Box{{1, 1, 1}}, {4, 0.25, 0.125}, {{-2, 0, 0}, {0, 0, 0}}), body(Box{{1, 1, 1}}, {0, 0, 0}), 4);
  expect(scene, 1, blind);
  scene.gravity = {0, 0, -10};
  expect(scene, 1, blind);
}

TEST_CASE("oracle: time of impact: balls that meet, and that pass") {
  const auto balls = [](double sideways) {
    return motion_scene(body(Sphere{1}, {4, 0, 0}, {{-2, sideways, 0}, {0, 0, 0}}), body(Sphere{1}, {0, 0, 0}), 4);
  };
  expect(balls(0), 1);
  expect(balls(-2), {});
}

// Bullet's subsimplex cast says of these that they meet after 4e12 times the way.
TEST_CASE("oracle: time of impact: tetrahedra that part with parallel edges") {
  const Polytope a{{{-1, -1, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, -2}}, {{0, 1, 3}, {0, 2, 1}, {0, 3, 2}, {1, 2, 3}}};
  const Polytope b{{{-2, -1, -4}, {1, 0, -4}, {-1, 1, 0}, {0, 0, 0}}, {{0, 1, 3}, {0, 2, 1}, {0, 3, 2}, {1, 2, 3}}};
  Scene scene =
      motion_scene(body(a, {0, 2, -1}, {{4, -8, 16}, {0, 0, 0}}), body(b, {0, 0, 0}, {{-4, -8, 16}, {0, 0, 0}}), 4);
  for (Body& one : scene.bodies) one.mass = Fixed{};
  expect(scene, {});
}

// A bar rotates clockwise towards a ball. Its face is 1/8 m from its axis; so contact with the ball of 1/2 m at 5/2 m
// occurs before the quarter turn, by the angle whose sine is (1/8 + 1/2)/(5/2). Then the same more slowly, from the
// other side.
TEST_CASE("oracle: time of impact: a bar that turns") {
  const Box bar{{0.125, 3, 1}};
  Scene scene = motion_scene(body(bar, {0, 0, 0}, {{0, 0, 0}, {0, 0, -1}}), body(Sphere{0.5}, {2.5, 0, 0}), 3);
  for (Body& one : scene.bodies) one.mass = MassProperties{1, Vec3::Zero(), Mat3::Identity()};
  expect(scene, 1.3181161);
  scene.bodies[0].velocity.w_WB = {0, 0, 0.5};
  scene.bodies[1].X_WB.p_WB = {-2.5, 0, 0};
  expect(scene, 2.6362322);
}

}  // namespace
}  // namespace touchstone::oracle
