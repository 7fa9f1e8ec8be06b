// Islands that merge, begin and end their steps, and release bodies.
#include "fast/simulation/island/island_event.h"

#include <cmath>

#include "tests/catch.h"
#include "tests/fast/simulation/scenes.h"

namespace touchstone::fast::simulation {
namespace {

/// A turntable (0), so that no contact has a closed form, and a ball (1) on a ball (2) on it, beside a third one (3).
struct Stack {
  explicit Stack(const Vec3& v = still)
      : scene(moving_scene(
            {turntable(), ball(1, {0, 0, 3}, v, {}), ball(1, {0, 0, 1}, still, {}), ball(1, {9, 0, 1}, still, {})}, g_W,
            {4})),
        run(scene, {.frame = 2}) {
    run.schedule.begin_frame();
  }
  static Body turntable() {
    Body body = table();
    body.velocity.w_WB = {0, 0, 0.125};
    return body;
  }

  Scene scene;
  Run run;
};

/// A table (0), a ball (2) that rests on it, and a ball (1) on that.
struct OnResting {
  OnResting()
      : scene(moving_scene({table(), ball(1, {0, 0, 3}, still, {}), ball(1, {0, 0, 1}, still, {})}, g_W, {4})),
        run(scene, {.frame = 2}) {
    run.schedule.begin_frame();
    RestingContact rest;
    rest.on = 0;
    run.rests.set(2, rest);
  }

  Scene scene;
  Run run;
};

TEST_CASE("island event: the contact point of a pair, if it touches") {
  Stack stack;
  const std::vector<PairPoints> points = contact_points_of(stack.run, 1, 2);
  REQUIRE(points.size() == 1);
  REQUIRE(points[0].size() == 1);
  const Touch& touch = points[0][0].touch;
  CHECK(touch.p_WC.z() == Approx(2));
  CHECK(touch.nhat_BA_W.z() == Approx(1));
  CHECK(contact_points_of(stack.run, 1, 3).empty());
}

TEST_CASE("island event: a pair joins with all that it is in contact with, or not if it is out of reach") {
  Stack stack;
  CHECK_FALSE(merge_islands(stack.run, 2, 3));
  CHECK(stack.run.islands.of(2) == nullptr);
  CHECK(merge_islands(stack.run, 0, 2));
  REQUIRE(stack.run.islands.of(2) != nullptr);
  CHECK(stack.run.islands.of(1) == nullptr);
  CHECK(merge_islands(stack.run, 1, 2));
  CHECK(stack.run.islands.of(1) == stack.run.islands.of(2));
  CHECK(stack.run.islands.of(1)->graph().bodies().size() == 3);
  CHECK(stack.run.islands.of(1)->waits());
}

TEST_CASE("island event: a body that rests takes its support into the island") {
  OnResting stack;
  Run& run = stack.run;
  REQUIRE(merge_islands(run, 1, 2));
  CHECK(run.islands.of(2)->graph().connects(0, 2));
  CHECK(run.rests.of(2) == nullptr);
}

TEST_CASE("island event: a step begins with contact events, and moves its bodies on represented trajectories") {
  Stack stack;
  REQUIRE(merge_islands(stack.run, 0, 2));
  begin_step(stack.run, 2);
  const Island* island = stack.run.islands.of(2);
  REQUIRE(island != nullptr);
  CHECK_FALSE(island->waits());
  CHECK(stack.run.recorder.statistics().of(Event::Kind::contact) == 1);
  CHECK(stack.run.recorder.statistics().contact_steps == 1);
  stack.run.advance_to(island->until());
  finish_step(stack.run, 2);
  CHECK(island->waits());
  CHECK(island->since() == stack.run.world.now());
  begin_step(stack.run, 2);
  CHECK(stack.run.recorder.statistics().of(Event::Kind::contact) == 1);  // the same contact
}

TEST_CASE("island event: an island at rest sleeps, and is not cut by time") {
  OnResting stack;
  Run& run = stack.run;
  REQUIRE(merge_islands(run, 1, 2));
  begin_step(run, 1);
  REQUIRE(run.islands.of(1) != nullptr);
  CHECK(run.islands.of(1)->sleeps());
  CHECK(is_stationary(run.world.body(1)));
  run.advance_to(1);
  cut_step(run, 1);
  CHECK(run.islands.of(1)->graph().state(1).X_WB.p_WB == Vec3(0, 0, 3));
  CHECK(std::abs(run.recorder.statistics().contact_loss) < 1e-12);
}

TEST_CASE("island event: a body on a face of a fixed block returns to the closed form") {
  const Scene scene = moving_scene({table(), ball(1, {0, 0, 1}, {1, 0, 0}, {})}, g_W, {4});
  Run run(scene, {.frame = 2});
  run.schedule.begin_frame();
  REQUIRE(merge_islands(run, 0, 1));
  begin_step(run, 1);
  CHECK(run.islands.of(1) == nullptr);
  CHECK(run.rests.rests_on(1, 0));
  CHECK(run.recorder.statistics().of(Event::Kind::contact) == 1);
}

TEST_CASE("island event: a body that separates is released and moves ballistically") {
  Stack stack({0, 0, 3});
  REQUIRE(merge_islands(stack.run, 1, 2));
  REQUIRE(merge_islands(stack.run, 0, 2));
  begin_step(stack.run, 1);
  CHECK(stack.run.islands.of(1) == nullptr);
  CHECK(stack.run.islands.of(2) != nullptr);
  CHECK(stack.run.recorder.statistics().of(Event::Kind::release) == 1);
  CHECK(stack.run.world.body(1).path().v == Vec3(0, 0, 3));
  CHECK(stack.run.world.body(1).path().a == g_W);
}

TEST_CASE("island event: a fast approach within an island is an impact") {
  Stack stack({0, 0, -3});
  REQUIRE(merge_islands(stack.run, 1, 2));
  begin_step(stack.run, 1);
  CHECK(stack.run.recorder.statistics().of(Event::Kind::impact) == 1);
  CHECK(stack.run.recorder.statistics().loss == Approx(0.5 * 9 / 2));  // e = 0 between equal masses
}

TEST_CASE("island event: a cut step ends now, and what it loses is counted") {
  Stack stack;
  REQUIRE(merge_islands(stack.run, 0, 2));
  begin_step(stack.run, 2);
  const double h = stack.run.islands.of(2)->until();
  stack.run.advance_to(h / 2);
  cut_step(stack.run, 2);
  cut_step(stack.run, 3);  // in no island
  CHECK(stack.run.islands.of(2)->since() == h / 2);
  CHECK(stack.run.islands.of(2)->waits());
  CHECK(stack.run.recorder.statistics().contact_loss >= -1e-12);
}

}  // namespace
}  // namespace touchstone::fast::simulation
