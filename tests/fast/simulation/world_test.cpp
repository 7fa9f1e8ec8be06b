// The bodies, what acts on them, and the time that does not go back.
#include "fast/simulation/world.h"

#include "model/input_error.h"
#include "tests/catch.h"
#include "tests/fast/simulation/scenes.h"

namespace touchstone::fast::simulation {
namespace {

TEST_CASE("world: needs a motion") {
  Scene scene;
  scene.bodies = {ball(1, Vec3::Zero(), Vec3::Zero(), {})};
  CHECK_THROWS_AS(World(scene), InputError);
}

TEST_CASE("world: lengths follow from the least body that moves") {
  // Sizes: 2 m and 1 m (half the shortest side); the table does not move.
  const Scene scene =
      moving_scene({ball(2, {0, 0, 9}, Vec3::Zero(), {}), brick({1, 2, 3}, {0, 0, 4}, {}), table(0.5)}, g_W, {0.5, 3});
  const World world(scene);
  CHECK(world.envelope() == 0x1p-30);
  CHECK(world.reach() == 0x1p-8);
  CHECK(world.end() == 3);
}

TEST_CASE("world: time never goes back") {
  const Scene scene = moving_scene({table()}, g_W, {1});
  World world(scene);
  CHECK(world.now() == 0);
  world.advance_to(0.75);
  world.advance_to(0.25);
  CHECK(world.now() == 0.75);
}

TEST_CASE("world: coefficients are the lesser of two, start times are 0 unless given") {
  Scene scene = moving_scene(
      {ball(1, {0, 0, 2}, Vec3::Zero(), {0.5, 0.25}), ball(1, {0, 0, 5}, Vec3::Zero(), {0.75, 0.125})}, g_W, {1});
  scene.motion->law = Law::newton;
  CHECK(World(scene).start_time(1) == 0);
  scene.motion->start_times = {0, 0.5};
  const World world(scene);
  CHECK(world.start_time(1) == 0.5);
  CHECK(world.body(1).path().since == 0.5);
  CHECK(world.coefficients(0, 1).restitution == 0.5);
  CHECK(world.coefficients(0, 1).friction == 0.125);
  CHECK(world.coefficients(0, 1).law == Law::newton);
}

TEST_CASE("world: an applied force replaces the one before, and adds to gravity") {
  Scene scene = moving_scene({ball(1, {0, 0, 2}, Vec3::Zero(), {}, 2)}, g_W, {4});
  scene.motion->forces = {{1, 0, {4, 0, 0}}, {2, 0, {0, 6, 0}}};
  World world(scene);
  CHECK(world.acceleration(0) == g_W);
  REQUIRE(world.next_force() != nullptr);
  CHECK(world.next_force()->time == 1);
  world.apply_next_force();
  CHECK(world.acceleration(0) == Vec3(2, 0, -10));
  REQUIRE(world.next_force() != nullptr);
  CHECK(world.next_force()->time == 2);
  world.apply_next_force();
  CHECK(world.acceleration(0) == Vec3(0, 3, -10));
  CHECK(world.next_force() == nullptr);
  CHECK(world.body(0).path().a == g_W);  // the trajectory is renewed by the event, not here
}

TEST_CASE("world: impacts are counted by body, and are at this time only until time goes on") {
  const Scene scene =
      moving_scene({ball(1, {0, 0, 2}, Vec3::Zero(), {}), ball(1, {0, 0, 5}, Vec3::Zero(), {}), table()}, g_W, {1});
  World world(scene);
  CHECK_FALSE(world.had_impact_now(0));
  world.count_impact(0, 2);
  world.count_impact(0, 1);
  world.count_impact(1, 3);
  CHECK(world.had_impact_now(0));
  CHECK(world.speed_before_impacts(0) == 2);
  CHECK(world.impacts(0, 1) == 3);
  CHECK(world.impacts(1, 2) == 1);
  world.advance_to(0.5);
  CHECK_FALSE(world.had_impact_now(0));
  CHECK(world.speed_before_impacts(0) == 0);
  CHECK(world.impacts(0, 1) == 3);
  world.count_impact(0, 1);
  CHECK(world.speed_before_impacts(0) == 1);
}

TEST_CASE("world: a body that will have turned by 2^13 radians restarts from its state") {
  Body slow = brick({1, 1, 1}, {0, 0, 4}, {}), fast = brick({1, 1, 1}, {9, 0, 4}, {});
  slow.velocity.w_WB = {0, 0, 8000};
  fast.velocity.w_WB = {0, 0, 9000};
  const Scene scene = moving_scene({slow, fast}, g_W, {1});
  World world(scene);
  world.advance_to(0.5);
  CHECK(world.keep_orientation(0, 1));
  CHECK(world.body(0).path().since == 0);
  CHECK(world.keep_orientation(1, 1));
  CHECK(world.body(1).path().since == 0.5);
  CHECK(world.body(1).path().v.z() == Approx(-5));
}

}  // namespace
}  // namespace touchstone::fast::simulation
