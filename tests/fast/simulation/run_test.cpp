// A run as a whole: frames, the end, and what it reports.
#include "fast/simulation/run.h"

#include "tests/catch.h"
#include "tests/fast/simulation/scenes.h"

namespace touchstone::fast::simulation {
namespace {

Scene drifting(std::vector<double> times) {
  return moving_scene({ball(1, Vec3::Zero(), {1, 0, 0}, {})}, Vec3::Zero(), std::move(times));
}

TEST_CASE("run: goes from frame to frame to the end of the motion, and samples at the end of each") {
  const Scene scene = drifting({0.5, 0.75});
  Run run(scene, {.frame = 0.5});
  run.schedule.begin_frame();
  run.advance_to(0.25);
  CHECK(run.world.now() == 0.25);
  run.end_frame();
  CHECK(run.world.now() == 0.5);
  CHECK_FALSE(run.is_over());
  run.schedule.begin_frame();
  run.end_frame();
  CHECK(run.world.now() == 0.75);
  CHECK(run.is_over());
  const Simulated done = run.result();
  CHECK_FALSE(done.stopped.has_value());
  REQUIRE(done.trajectory.states.size() == 2);
  CHECK(done.trajectory.states[1][0].X_WB.p_WB == Vec3(0.75, 0, 0));
  CHECK(done.momentum.empty());
}

TEST_CASE("run: one that stops stays where it is") {
  const Scene scene = drifting({0.25, 0.75});
  Run run(scene, {.frame = 0.5});
  run.schedule.begin_frame();
  run.advance_to(0.25);
  run.guard.stop(0.25, 0, {}, "because");
  run.end_frame();
  CHECK(run.is_over());
  CHECK(run.world.now() == 0.25);
  const Simulated done = run.result();
  CHECK(done.trajectory.states.size() == 1);
  CHECK(done.trajectory.complete_until == 0.25);
  CHECK(done.trajectory.gave_up == "because: bodies[0]");
}

TEST_CASE("run: at most 2^13 frames") {
  const Scene scene = drifting({8192});
  Run run(scene, {.frame = 0.125});
  run.schedule.begin_frame();
  CHECK(run.schedule.frame_end() == 1);
}

TEST_CASE("run: momentum is reported if it is kept exact") {
  const Scene scene = drifting({1});
  Run run(scene, {.exact_momentum = true});
  const Simulated done = run.result();
  CHECK(done.momentum_before == std::vector<Vec3>{{1, 0, 0}});
  CHECK(done.momentum == done.momentum_before);
}

TEST_CASE("run: in contact are bodies that rest, and those in islands") {
  const Scene scene = moving_scene({ball(1, {0, 0, 1}, Vec3::Zero(), {}), table()}, {0, 0, -10}, {1});
  Run run(scene, {});
  CHECK_FALSE(run.is_in_contact(0));
  run.rests.set(0, {});
  CHECK(run.is_in_contact(0));
  CHECK_FALSE(run.is_in_contact(1));
}

}  // namespace
}  // namespace touchstone::fast::simulation
