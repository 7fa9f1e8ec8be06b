// What an impulse changes, and pairs that collide in one place again and again.
#include "fast/simulation/impact_event.h"

#include "tests/catch.h"
#include "tests/fast/simulation/scenes.h"

namespace touchstone::fast::simulation {
namespace {

TEST_CASE("impact event: both bodies continue with their new velocities, and are predicted again") {
  const Scene scene = moving_scene(
      {ball(1, {-1, 0, 0}, {3, 0, 0}, {1, 0}), ball(1, {1, 0, 0}, still, {1, 0}), ball(1, {5, 0, 0}, still, {1, 0})},
      still, {1});
  Run run(scene, {.frame = 1});
  run.schedule.begin_frame();
  run.schedule.predict_frame();
  ImpactResult result;
  result.P_A_W = {-3, 0, 0};
  result.after_b.v_WBcm = {3, 0, 0};
  result.loss = 0.25;
  apply_impulse(run, Event::Kind::impact, 0, 1, {0, still, {-1, 0, 0}}, result);
  CHECK(run.world.body(0).path().v == still);
  CHECK(run.world.body(1).path().v == Vec3(3, 0, 0));
  CHECK(run.world.had_impact_now(0));
  CHECK(run.world.impacts(0, 1) == 2);
  REQUIRE(run.schedule.next() != nullptr);
  CHECK(run.schedule.next()->a == 1);
  CHECK(run.schedule.next()->b == 2);
  CHECK(run.schedule.next()->time == Approx(2.0 / 3));
  const Simulated done = run.result();
  CHECK(done.statistics.loss == 0.25);
  REQUIRE(done.trajectory.events->size() == 1);
  CHECK(done.trajectory.events->front().P_A_W == Vec3(-3, 0, 0));
  CHECK(done.trajectory.events->front().after_b.velocity.v_WBcm == Vec3(3, 0, 0));
}

TEST_CASE("impact event: momentum that a fixed body takes, and a resting contact that an impact ends") {
  const Scene scene = moving_scene({ball(1, up, {0, 0, -2}, {1, 0}), table()}, still, {1});
  Run run(scene, {.frame = 1});
  run.schedule.begin_frame();
  RestingContact rest;
  rest.on = 1;
  rest.nhat_W = up;
  run.rests.set(0, rest);
  ImpactResult result;
  result.P_A_W = 4 * up;
  result.after_a.v_WBcm = 2 * up;
  apply_impulse(run, Event::Kind::impact, 0, 1, {0, still, up}, result);
  CHECK(run.rests.of(0) == nullptr);
  CHECK(run.recorder.statistics().of(Event::Kind::release) == 1);
  CHECK(run.recorder.statistics().to_fixed == -4 * up);
  CHECK_FALSE(run.world.had_impact_now(1));
}

TEST_CASE("impact event: after 32 impacts in one place a pair of bodies with corners collides endlessly") {
  const Scene scene =
      moving_scene({brick({1, 1, 1}, {0, 0, 3}, {}), table(), ball(1, {9, 0, 1}, still, {})}, still, {1});
  Run run(scene, {});
  for (int i = 0; i < 32; ++i) CHECK_FALSE(collides_endlessly(run, 0, 1, -1e-12));
  CHECK(collides_endlessly(run, 0, 1, -1e-12));
  run.world.advance_to(0.5);
  CHECK_FALSE(collides_endlessly(run, 0, 1, -1));  // half a metre later: the count begins again
  for (int i = 0; i < 100; ++i) CHECK_FALSE(collides_endlessly(run, 1, 2, -1e-12));  // a ball has one contact point
}

}  // namespace
}  // namespace touchstone::fast::simulation
