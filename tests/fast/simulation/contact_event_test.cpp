// A predicted contact whose time has come: each response, in a small scene.
#include "fast/simulation/contact_event.h"

#include "fast/simulation/trajectory.h"
#include "tests/catch.h"
#include "tests/fast/simulation/scenes.h"

namespace touchstone::fast::simulation {
namespace {

/// Runs up to the first predicted contact, and resolves it.
void resolve_first(Run& run) {
  begin_frame(run);
  REQUIRE(run.schedule.next() != nullptr);
  run.advance_to(run.schedule.next()->time);
  resolve_contact(run, run.schedule.pop());
}

TEST_CASE("contact event: a fast ball bounces") {
  const Scene scene = moving_scene({ball(1, {0, 0, 6}, still, {0.5, 0}), table()}, g_W, {4});
  Run run(scene, {.frame = 4});
  resolve_first(run);
  CHECK(run.recorder.statistics().of(Event::Kind::impact) == 1);
  CHECK(run.world.body(0).path().v.z() == Approx(5));  // down with 10, up with e · 10
  CHECK_FALSE(run.is_in_contact(0));
  REQUIRE(run.schedule.next() != nullptr);
  CHECK(run.schedule.next()->time == Approx(2));
}

TEST_CASE("contact event: a slow ball rests on a face") {
  const Scene scene = moving_scene({ball(1, {0, 0, 1 + 1e-12}, still, {0.5, 0}), table()}, g_W, {4});
  Run run(scene, {.frame = 2});
  resolve_first(run);
  CHECK(run.rests.rests_on(0, 1));
  CHECK(run.recorder.statistics().of(Event::Kind::impact) == 0);
  CHECK(run.recorder.statistics().of(Event::Kind::contact) == 1);
}

TEST_CASE("contact event: an inelastic ball rests at once, its micro-bounces completed") {
  const Scene scene = moving_scene({ball(1, {0, 0, 6}, still, {0, 0}), table()}, g_W, {4});
  Run run(scene, {.frame = 2});
  resolve_first(run);
  CHECK(run.recorder.statistics().of(Event::Kind::impact) == 1);
  CHECK(run.rests.rests_on(0, 1));
  CHECK(run.world.body(0).path().v.z() == Approx(0).margin(1e-12));
}

TEST_CASE("contact event: a slow contact without closed form joins an island, or micro-bounces") {
  Body turntable = table();
  turntable.velocity.w_WB = {0, 0, 1};
  const Scene scene = moving_scene({ball(1, {0, 0, 1 + 1e-12}, still, {0.5, 0}), turntable}, g_W, {4});
  Run island(scene, {.frame = 2});
  resolve_first(island);
  REQUIRE(island.islands.of(0) != nullptr);
  CHECK(island.islands.of(0)->waits());
  Run bounces(scene, {.frame = 2, .micro_collisions = true});
  resolve_first(bounces);
  CHECK(bounces.islands.of(0) == nullptr);
  CHECK(bounces.recorder.statistics().of(Event::Kind::micro_collision) == 1);
  CHECK(bounces.world.body(0).path().v.z() > 0);
}

TEST_CASE("contact event: two that are farther apart than predicted are predicted again") {
  for (const double time : {0.5, 0.9375, 0.999}) {  // 5 − 5 t² above it: 3.75 m, 0.6 m, 1 cm
    const Scene scene = moving_scene({ball(1, {0, 0, 6}, still, {}), table()}, g_W, {4});
    Run run(scene, {.frame = 2});
    begin_frame(run);
    run.schedule.pop();
    run.advance_to(time);
    resolve_contact(run, {time, 0, 1});
    CHECK(run.recorder.statistics().events() == 0);
    REQUIRE(run.schedule.next() != nullptr);
    CHECK(run.schedule.next()->time == Approx(1));
  }
}

TEST_CASE("contact event: bodies too far away for doubles stop the run") {
  const Scene scene =
      moving_scene({ball(1, {0x1p45, 0, 0}, {1, 0, 0}, {}), ball(1, {0x1p45 + 4, 0, 0}, still, {})}, still, {4});
  Run run(scene, {.frame = 2});
  begin_frame(run);
  run.advance_to(1);
  resolve_contact(run, {1, 0, 1});
  REQUIRE(run.stopped());
  CHECK_THAT(run.guard.stopped()->why, Catch::Contains("rounding"));
}

TEST_CASE("contact event: a search that was cut off stops the run where it ended") {
  const Scene scene = moving_scene(
      {brick({1, 1, 1}, {0, 0, 4}, {}), ball(1, {0, 0, 0}, still, {}), brick({1, 1, 1}, {0, 0, 9}, {})}, still, {4});
  Run run(scene, {.frame = 2});
  begin_frame(run);
  run.schedule.memory(0, 2).is_cut_off = true;
  run.advance_to(1);
  resolve_contact(run, {1, 0, 2});
  REQUIRE(run.stopped());
  CHECK_THAT(run.guard.stopped()->why, Catch::Contains("separation queries"));
  CHECK(run.guard.stopped()->time == 1);
}

TEST_CASE("contact event: a run with more events than allowed stops") {
  const Scene scene = moving_scene({ball(1, {0, 0, 6}, still, {1, 0}), table()}, g_W, {4});
  Run run(scene, {.frame = 2, .most_events = 0});
  resolve_first(run);
  CHECK(run.stopped());
}

}  // namespace
}  // namespace touchstone::fast::simulation
