// Samples at and before a time, events that are kept or only counted, and why a run stopped.
#include "fast/simulation/recorder.h"

#include "tests/catch.h"
#include "tests/fast/simulation/scenes.h"

namespace touchstone::fast::simulation {
namespace {

Scene moving_ball() { return moving_scene({ball(1, Vec3::Zero(), {2, 0, 0}, {})}, Vec3::Zero(), {0.5, 1, 1.5}); }

TEST_CASE("recorder: samples before a time leave out the time itself, samples through it do not") {
  const Scene scene = moving_ball();
  World world(scene);
  const Islands islands(world);
  Recorder recorder(world, islands, true);
  recorder.sample_before(1);
  recorder.sample_before(1);
  world.body(0).restart(1, {{{9, 0, 0}, {}}, {}}, Vec3::Zero());  // an event at 1 s
  recorder.sample_through(1);
  recorder.sample_through(1.5);
  const Simulated done = recorder.take({});
  REQUIRE(done.trajectory.states.size() == 3);
  CHECK(done.trajectory.states[0][0].X_WB.p_WB == Vec3(1, 0, 0));
  CHECK(done.trajectory.states[1][0].X_WB.p_WB == Vec3(9, 0, 0));
  CHECK(done.trajectory.states[2][0].X_WB.p_WB == Vec3(9, 0, 0));
  CHECK_FALSE(done.stopped.has_value());
  CHECK(done.trajectory.gave_up.empty());
  CHECK_FALSE(done.trajectory.complete_until.has_value());
}

TEST_CASE("recorder: a body in an island is where the island says") {
  const Scene scene = moving_ball();
  World world(scene);
  Islands islands(world);
  ContactGraph graph(0, 0);
  graph.add({0, &world.body(0), {&world.body(0).model(), {{{5, 0, 0}, {}}, {}}, Vec3::Zero()}});
  islands.insert(Island(graph, 0));
  Recorder recorder(world, islands, true);
  recorder.sample_through(0.5);
  CHECK(recorder.take({}).trajectory.states[0][0].X_WB.p_WB == Vec3(5, 0, 0));
}

TEST_CASE("recorder: events are counted even if they are not kept") {
  const Scene scene = moving_ball();
  const World world(scene);
  const Islands islands(world);
  for (const bool keeps : {true, false}) {
    Recorder recorder(world, islands, keeps);
    Event event;
    event.kind = Event::Kind::release;
    recorder.record(event);
    recorder.record(event);
    const Simulated done = recorder.take({});
    CHECK(done.statistics.of(Event::Kind::release) == 2);
    REQUIRE(done.trajectory.events.has_value() == keeps);
    if (keeps) CHECK(done.trajectory.events->size() == 2);
  }
}

TEST_CASE("recorder: a run that stopped says when, why and at which bodies") {
  const Scene scene = moving_ball();
  World world(scene);
  world.advance_to(0.75);
  const Islands islands(world);
  const Simulated pair = Recorder(world, islands, true).take(Stopped{0.75, 3, 4, "because"});
  CHECK(pair.trajectory.gave_up == "because: bodies[3] and bodies[4]");
  CHECK(pair.trajectory.complete_until == 0.75);
  CHECK(Recorder(world, islands, true).take(Stopped{0.75, 3, -1, "because"}).trajectory.gave_up ==
        "because: bodies[3]");
}

}  // namespace
}  // namespace touchstone::fast::simulation
