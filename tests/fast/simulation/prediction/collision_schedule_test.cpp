// What is predicted within a frame, and what is dropped or left out.
#include "fast/simulation/prediction/collision_schedule.h"

#include <cmath>

#include "model/input_error.h"
#include "tests/catch.h"
#include "tests/fast/simulation/island/island_bodies.h"

namespace touchstone::fast::simulation {
namespace {

struct Parts {
  explicit Parts(std::vector<Body> bodies, double frame = 1)
      : scene(moving_scene(std::move(bodies), still, {3.5})),
        world(scene),
        islands(world),
        rests(scene.bodies.size()),
        guard({}, frame, 3.5, scene.bodies.size()),
        schedule(world, islands, rests, frame, statistics, guard) {}

  void begin_frame() {
    schedule.begin_frame();
    schedule.predict_frame();
  }

  Scene scene;
  World world;
  Islands islands;
  RestingBodies rests;
  Statistics statistics;
  StallGuard guard;
  CollisionSchedule schedule;
};

Body coming(double x, double v) { return ball(1, {x, 0, 0}, {v, 0, 0}, {}); }

TEST_CASE("collision schedule: a contact is predicted in the frame in which it happens") {
  Parts parts({coming(-2.5, 1), coming(2.5, -1), ball(1, {0, 99, 0}, still, {})});  // 3 m at 2 m/s
  parts.begin_frame();
  CHECK(parts.schedule.frame_end() == 1);
  CHECK(parts.schedule.next() == nullptr);
  parts.world.advance_to(1);
  parts.begin_frame();
  CHECK(parts.schedule.frame_end() == 2);
  REQUIRE(parts.schedule.next() != nullptr);
  const PairEvent event = parts.schedule.pop();
  CHECK(event.time == Approx(1.5));
  CHECK(event.a == 0);
  CHECK(event.b == 1);
  CHECK(parts.schedule.next() == nullptr);
  CHECK(parts.statistics.frames == 2);
  parts.begin_frame();
  parts.begin_frame();
  CHECK(parts.schedule.frame_end() == 3.5);  // of the motion
}

TEST_CASE("collision schedule: pairs whose boxes do not intersect are not queried") {
  Parts parts({coming(-9, 1), coming(9, -1), ball(1, {0, 99, 0}, still, {})});
  parts.begin_frame();
  CHECK(parts.statistics.pairs == 0);
}

TEST_CASE("collision schedule: a new trajectory drops what was predicted, and is predicted on request") {
  Parts parts({coming(-1.5, 1), coming(1.5, -1), ball(1, {-1.5, 2.5, 0}, still, {})});
  parts.begin_frame();
  REQUIRE(parts.schedule.next() != nullptr);
  parts.world.advance_to(0.25);
  parts.world.body(0).restart(0.25, {{{-1.25, 0, 0}, {}}, {{0, 1, 0}, still}}, still);  // 0.5 m above it: body 2
  parts.schedule.trajectory_changed(0);
  CHECK(parts.schedule.next() == nullptr);
  parts.schedule.predict_all(0, 2);
  REQUIRE(parts.schedule.next() != nullptr);
  CHECK(parts.schedule.next()->b == 1);  // (2.5 − τ)² + τ² = 4, after 0.25 s
  CHECK(parts.schedule.next()->time == Approx(0.25 + (5 - std::sqrt(7)) / 4));
  parts.schedule.predict_all(0);
  REQUIRE(parts.schedule.next() != nullptr);
  CHECK(parts.schedule.next()->b == 2);
  CHECK(parts.schedule.next()->time > 0.7);
  CHECK(parts.schedule.next()->time < 0.8);
}

TEST_CASE("collision schedule: fixed bodies are not queried with each other") {
  Parts parts({table(), table()});  // they overlap
  parts.begin_frame();
  parts.schedule.predict(0, 1, 0);
  CHECK(parts.statistics.pairs == 0);
  CHECK(parts.schedule.next() == nullptr);
}

TEST_CASE("collision schedule: bodies that overlap when both have started are refused") {
  Parts parts({coming(-0.75, 0), coming(0.75, 0)});
  try {
    parts.begin_frame();
    FAIL("not refused");
  } catch (const InputError& error) {
    CHECK_THAT(error.what(), Catch::StartsWith("bodies[0]"));
    CHECK_THAT(error.what(), Catch::Contains("overlaps bodies[1] at the start by 0.5"));
  }
}

// When the second one starts, the first one has come 1188 m, which is known to 2e-13 m. They touch to within that.
TEST_CASE("collision schedule: bodies that touch when the later one starts do not overlap by rounding") {
  const double speed = 2457.5244425409055, starts = 0.4835812086661767;
  Scene scene = moving_scene(
      {ball(0.05, still, {speed, 0, 0}, {}), ball(0.05, {1188.5126402506032, 0, 0}, {2500, 0, 0}, {})}, still, {0.6});
  scene.motion->start_times = {0, starts};
  CHECK_NOTHROW(simulate(scene));
  scene.bodies[1].X_WB.p_WB.x() -= 1e-9;
  CHECK_THROWS_AS(simulate(scene), InputError);
}

TEST_CASE("collision schedule: a body that rests is due when its resting contact ends") {
  Parts parts({ball(1, {0, 0, 1}, {1, 0, 0}, {}), table()});
  RestingContact rest;
  rest.on = 1;
  rest.until = 0.75;
  parts.rests.set(0, rest);
  parts.begin_frame();
  REQUIRE(parts.schedule.next() != nullptr);
  CHECK(parts.schedule.next()->time == 0.75);
}

TEST_CASE("collision schedule: a contact pair of an island, and an island that waits, are not queried") {
  Parts parts({table(), ball(1, {0, 0, 1}, {2, 0, 0}, {}), ball(1, {2.5, 0, 1}, still, {})});
  const IslandBodies bodies(parts.scene.bodies, still);
  ContactGraph graph(0x1p-10, 0x1p-8);
  graph.add(bodies[0]);
  graph.add(bodies[1]);
  REQUIRE(graph.link(0, 1));
  parts.islands.insert(Island(graph, 0));
  parts.begin_frame();  // 2 m/s towards the ball half a metre in front of it, but it waits
  CHECK(parts.schedule.next() == nullptr);
  parts.islands.of(1)->begin_step(4, 1);  // an eighth of a second
  parts.schedule.predict(0, 1, 0);
  CHECK(parts.schedule.next() == nullptr);
  parts.schedule.predict(1, 2, 0);
  CHECK(parts.schedule.next() == nullptr);  // not within the step
  parts.islands.of(1)->end_step(0);
  parts.islands.of(1)->begin_step(1, 1);  // half a second
  parts.schedule.predict(1, 2, 0);
  REQUIRE(parts.schedule.next() != nullptr);
  CHECK(parts.schedule.next()->time == Approx(0.25).margin(0.01));
}

/// A ball that slides and one at rest, each on the table in an island of its own. Do they count as in contact if they
/// pass each other `gap` apart?
bool take_steps_together(double gap) {
  constexpr double friction = 0x1p-12;  // so that the step bends the trajectory, but by far less than `gap`
  Parts parts({table(), ball(1, {0, 0, 1}, {2, 0, 0}, {0, friction}), ball(1, {0.125, 2 + gap, 1}, still, {})});
  const IslandBodies bodies(parts.scene.bodies, g_W);
  for (const BodyId id : {BodyId{1}, BodyId{2}}) {
    ContactGraph graph(0x1p-10, 0x1p-8);
    graph.add(bodies[0]);
    graph.add(bodies[id]);
    REQUIRE(graph.link(0, id));
    parts.islands.insert(Island(graph, 0));
    parts.islands.of(id)->begin_step(1, 0.125);
    REQUIRE(parts.islands.of(id)->until() == 0.125);
  }
  const double margin = parts.islands.of(1)->deviation().margin;
  REQUIRE(margin > 0);
  REQUIRE(margin < parts.world.reach() / 64);
  parts.begin_frame();
  parts.schedule.predict(1, 2, 0);
  return parts.schedule.next() != nullptr;
}

// A search ends within twice the distance that it looks for.
TEST_CASE("collision schedule: balls of two islands that pass within a quarter of the reach are in contact") {
  const double reach = World(moving_scene({coming(0, 0), table()}, still, {3.5})).reach();
  CHECK(take_steps_together(reach * 3 / 16));
  CHECK_FALSE(take_steps_together(reach * 9 / 16));
}

TEST_CASE("collision schedule: nearest points now, and a memory for each pair") {
  Parts parts({coming(-1.5, 1), coming(1.5, -1), coming(9, 0)});
  const Touch touch = parts.schedule.nearest_points(0, 1, 0.25);
  CHECK(touch.gap == Approx(0.5));
  CHECK(touch.nhat_BA_W == Vec3(-1, 0, 0));
  parts.schedule.memory(0, 1).last_impact = 7;
  CHECK(parts.schedule.memory(0, 1).last_impact == 7);
  CHECK(parts.schedule.memory(0, 2).last_impact == -1);
}

}  // namespace
}  // namespace touchstone::fast::simulation
