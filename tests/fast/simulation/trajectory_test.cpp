// Events that give a body a new trajectory.
#include "fast/simulation/trajectory.h"

#include "tests/catch.h"
#include "tests/fast/simulation/scenes.h"

namespace touchstone::fast::simulation {
namespace {

TEST_CASE("trajectory: a frame begins with the contacts that may happen in it") {
  const Scene scene = moving_scene({ball(1, {0, 0, 6}, still, {}), table()}, g_W, {4});
  Run run(scene, {.frame = 2});
  begin_frame(run);
  REQUIRE(run.schedule.next() != nullptr);
  CHECK(run.schedule.next()->time == Approx(1));  // 5 m at 10 m/s²
}

TEST_CASE("trajectory: a tumbling body that cannot be followed for a frame stops the run") {
  // Exactly about its middle axis, whose tumble has no known period.
  Body body = brick({1, 2, 3}, {0, 0, 9}, {});
  body.velocity.w_WB = {1e-8, 1e6, 1e-8};
  const Scene scene = moving_scene({body}, still, {4});
  Run run(scene, {.frame = 2});
  begin_frame(run);
  REQUIRE(run.stopped());
  CHECK(run.guard.stopped()->why == "turns too fast to be followed for a frame");
  CHECK(run.guard.stopped()->a == 0);
  CHECK(run.guard.stopped()->b == -1);
}

TEST_CASE("trajectory: a body continues from the state, under what accelerates it, a fixed one is left alone") {
  const Scene scene = moving_scene({ball(1, {0, 0, 6}, still, {}), table()}, g_W, {4});
  Run run(scene, {.frame = 2});
  begin_frame(run);
  run.advance_to(0.5);
  set_trajectory(run, 0, {{{0, 0, 3}, {}}, {{0, 0, 4}, still}});
  set_trajectory(run, 1, {{{0, 0, 3}, {}}, {{0, 0, 4}, still}});
  CHECK(run.schedule.next() == nullptr);  // what was predicted is dropped
  CHECK(run.world.body(0).path().since == 0.5);
  CHECK(run.world.body(0).state(0.75).velocity.v_WBcm == Vec3(0, 0, 1.5));
  CHECK(run.world.body(1).path().p == Vec3(0, 0, -1));
}

TEST_CASE("trajectory: an applied force acts from its time on, and its contacts are predicted again") {
  Scene scene = moving_scene({ball(1, {0, 0, 6}, still, {}, 2), table()}, still, {4});
  scene.motion->forces = {{0, 0, {2, 0, 0}}, {1, 0, {0, 0, -20}}};
  Run run(scene, {.frame = 4});
  begin_frame(run);
  CHECK(run.schedule.next() == nullptr);
  apply_force(run);
  CHECK(run.recorder.statistics().events() == 0);  // it acts since the start
  CHECK(run.world.body(0).path().a == Vec3(1, 0, 0));
  run.advance_to(1);
  apply_force(run);
  CHECK(run.recorder.statistics().of(Event::Kind::force) == 1);
  CHECK(run.world.body(0).path().a == Vec3(0, 0, -10));
  CHECK(run.world.body(0).path().v == Vec3(1, 0, 0));
  REQUIRE(run.schedule.next() != nullptr);
  CHECK(run.schedule.next()->time == Approx(2));
}

}  // namespace
}  // namespace touchstone::fast::simulation
