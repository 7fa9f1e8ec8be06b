// When a pair that is no contact yet is queried again.
#include "fast/simulation/later.h"

#include <cmath>

#include "tests/catch.h"
#include "tests/fast/simulation/island/island_bodies.h"

namespace touchstone::fast::simulation {
namespace {

TEST_CASE("later: bodies in ballistic motion are predicted again at once") {
  const Scene scene = moving_scene({ball(1, {0, 0, 6}, still, {}), table()}, g_W, {4});
  Run run(scene, {.frame = 4});
  run.schedule.begin_frame();
  recheck(run, 0, 1);
  REQUIRE(run.schedule.next() != nullptr);
  CHECK(run.schedule.next()->time == Approx(1));
}

TEST_CASE("later: a pair that separates is queried after a time in which it cannot approach noticeably") {
  Scene scene = moving_scene({ball(1, {0, 0, 1}, still, {}), table()}, g_W, {4});
  scene.motion->envelope = 0x1p-20;
  Run run(scene, {.frame = 4});
  run.schedule.begin_frame();
  schedule_later(run, 0, 1, {0, still, {0, 0, 1}});
  REQUIRE(run.schedule.next() != nullptr);
  // From rest it falls by a sixteenth of the envelope in sqrt(2 ε/16/g).
  const double falls = std::sqrt(2 * 0x1p-24 / 10);
  CHECK(run.schedule.next()->time >= 0.99 * falls);
  CHECK(run.schedule.next()->time <= 2 * falls);
}

TEST_CASE("later: far from the origin a separating pair is queried when it may have approached by more than rounding") {
  const Vec3 far{0x1p22, 0, 0};
  Scene scene = moving_scene({ball(1, far + Vec3(0, 0, 1), still, {}), table()}, g_W, {4});
  scene.bodies[1].X_WB.p_WB += far;
  scene.motion->envelope = 0x1p-40;
  Run run(scene, {.frame = 4});
  const double unresolved = 2 * clearance(run.world.body(0), run.world.body(1), 0, never);
  REQUIRE(unresolved > 1000 * run.world.envelope());
  run.schedule.begin_frame();
  schedule_later(run, 0, 1, {0, still, {0, 0, 1}});
  REQUIRE(run.schedule.next() != nullptr);
  const double falls = std::sqrt(2 * unresolved / 16 / 10);
  CHECK(run.schedule.next()->time >= 0.99 * falls);
  CHECK(run.schedule.next()->time <= 2 * falls);
}

TEST_CASE("later: a body that slides along a face without any force is not queried again") {
  const Body free_box = brick({4, 4, 1}, {0, 0, -1}, {});
  for (const Body& support : {table(), free_box}) {
    for (const Body& slider : {ball(1, {0, 0, 1}, {3, 0, 0}, {}), brick({1, 1, 1}, {0, 0, 1}, {})}) {
      const Scene scene = moving_scene({slider, support}, still, {4});
      Run run(scene, {.frame = 4});
      run.schedule.begin_frame();
      schedule_later(run, 0, 1, {0, still, {0, 0, 1}});
      CHECK(run.schedule.next() == nullptr);
    }
  }
}

TEST_CASE("later: nor is one that slides along a floor and a wall that are one body, with a part far away") {
  Body fixed = table();
  fixed.X_WB = {};
  fixed.shape = Compound{
      {{{{0, 0, -1}, {}}, Box{{8, 8, 1}}}, {{{-9, 0, 0}, {}}, Box{{1, 1, 4}}}, {{{0, 2, 4}, {}}, Box{{8, 1, 4}}}}};
  Body slider = brick({1, 1, 1}, {0, 0, 1}, {});
  slider.velocity.v_WBcm = {3, 0, 0};
  const auto next_of = [&fixed](const Body& moving) -> double {
    const Scene scene = moving_scene({moving, fixed}, still, {4});
    Run run(scene, {.frame = 4});
    run.schedule.begin_frame();
    schedule_later(run, 0, 1, {0, still, {0, 0, 1}});
    return run.schedule.next() ? run.schedule.next()->time : never;
  };
  CHECK(next_of(slider) == never);
  slider.velocity.v_WBcm = {-3, 0, 0};  // the part at its left is 7 m away
  CHECK(next_of(slider) == Approx(7.0 / 3));
}

TEST_CASE("later: a body in an island gets shorter steps instead, and the pair remembers that it separated") {
  const Scene scene =
      moving_scene({table(), ball(1, {0, 0, 1}, {1, 0, 0}, {}), brick({1, 1, 1}, {2, 0, 3}, {})}, still, {4});
  Run run(scene, {.frame = 4});
  run.schedule.begin_frame();
  const IslandBodies bodies(scene.bodies, still);
  ContactGraph graph(0x1p-10, 0x1p-8);
  graph.add(bodies[0]);
  graph.add(bodies[1]);
  REQUIRE(graph.link(0, 1));
  run.islands.insert(Island(graph, 0));
  Island& island = *run.islands.of(1);
  island.begin_step(1, 4);
  const double h = island.until();
  recheck(run, 1, 2);
  CHECK(run.schedule.next() == nullptr);
  schedule_later(run, 1, 2, {0, still, {0, 0, -1}});
  CHECK(run.schedule.memory(1, 2).separating_at == 0);
  CHECK(run.schedule.memory(1, 2).not_queried_at == -1);
  island.end_step(0);
  island.begin_step(1, 4);
  CHECK(island.until() == Approx(h / 4));
}

}  // namespace
}  // namespace touchstone::fast::simulation
