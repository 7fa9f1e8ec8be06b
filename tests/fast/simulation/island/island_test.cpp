// The clock of an island: steps that begin, end early, become shorter and longer, and sleep.
#include "fast/simulation/island/island.h"

#include "tests/catch.h"
#include "tests/fast/simulation/island/island_bodies.h"

namespace touchstone::fast::simulation {
namespace {

TEST_CASE("island: it waits until its step begins, and the step lasts a part of the fall by its size") {
  const IslandBodies falls({ball(2, {0, 0, 50}, still, {})}, {0, 0, -8});
  Island island(falls.graph(near, reach), 3);
  CHECK(island.waits());
  CHECK_FALSE(island.sleeps());
  CHECK(island.since() == 3);
  CHECK(island.states_at(5)[0].X_WB.p_WB.z() == 50);
  island.begin_step(4, 100);  // sqrt(8/2) = 2 per second: an eighth of a second
  CHECK_FALSE(island.waits());
  CHECK(island.until() == Approx(3.125));
  CHECK(island.deviation().margin == Approx(0.125 * 1 / 4));  // the velocity changes by 1 m/s
  CHECK(island.drift() == Approx(2 * 0.03125 / 0.125));
}

TEST_CASE("island: samples inside a step change no state, ending it does, at its end or before") {
  const IslandBodies falls({ball(2, {0, 0, 50}, still, {})}, {0, 0, -8});
  for (const double end : {3.125, 3.0625}) {
    Island island(falls.graph(near, reach), 3);
    island.begin_step(4, 100);
    CHECK(island.states_at(3.0625)[0].X_WB.p_WB.z() == Approx(50 - 4 * 0.0625 * 0.0625).epsilon(1e-14));
    CHECK(island.graph().state(0).X_WB.p_WB.z() == 50);
    island.end_step(end);
    CHECK(island.waits());
    CHECK(island.since() == end);
    CHECK(island.graph().state(0).X_WB.p_WB.z() == Approx(50 - 4 * (end - 3) * (end - 3)).epsilon(1e-14));
    CHECK(island.graph().state(0).velocity.v_WBcm.z() == Approx(-8 * (end - 3)));
  }
}

TEST_CASE("island: steps become a quarter as long, down to a limit, and longer again") {
  const IslandBodies drifts({ball(1, {0, 0, 50}, {1, 0, 0}, {})}, still);
  Island island(drifts.graph(near, reach), 0);
  CHECK(island.shorten(0x1p-20));  // there has been no step
  island.begin_step(1, 100);
  CHECK(island.until() == 1);
  CHECK(island.shorten(0x1p-20));
  island.end_step(0);
  island.begin_step(1, 100);
  CHECK(island.until() == 0.25);
  island.bound().lengthen();
  island.end_step(0);
  island.begin_step(1, 100);
  CHECK(island.until() == 0.5);
  CHECK(island.shorten(0.25));
  island.end_step(0);
  island.begin_step(1, 100);
  CHECK(island.until() == 0.25);  // no shorter than a quarter of the longest
  CHECK_FALSE(island.shorten(0.25));
}

TEST_CASE("island: shortened steps grow ever faster, and at once when their contact has come") {
  const IslandBodies drifts({ball(1, {0, 0, 50}, {1, 0, 0}, {})}, still);
  Island island(drifts.graph(near, reach), 0);
  const auto length = [&] {
    island.begin_step(1, 100);
    const double until = island.until();
    island.end_step(0);
    return until;
  };
  CHECK(length() == 1);
  island.shorten(0x1p-20, 0x1p-13);  // twice that, since the contact should come within the step
  CHECK(length() == 0x1p-12);
  for (const double expected : {0x1p-11, 0x1p-9, 0x1p-5, 1.0}) {
    island.bound().lengthen();
    CHECK(length() == expected);
  }
  island.shorten(0x1p-20, 100);  // a quarter at least
  CHECK(length() == 0.25);
  island.bound().lift();
  CHECK(length() == 1);
}

TEST_CASE("island: asleep nothing moves, for however long") {
  const IslandBodies lies({ball(1, {0, 0, 1}, still, {}), table()}, g_W);
  Island island(lies.graph(near, reach), 0);
  island.sleep();
  CHECK(island.sleeps());
  CHECK_FALSE(island.waits());
  CHECK(island.until() == never);
  CHECK(island.drift() == 0);
  CHECK(island.states_at(1e9)[0] == lies[0].state());
  island.end_step(1e9);
  CHECK(island.since() == 1e9);
  CHECK(island.graph().state(0) == lies[0].state());
}

TEST_CASE("island: four impacts for each contact pair at one time, and as many at the next") {
  const IslandBodies lies({ball(1, {0, 0, 1}, still, {}), table()}, g_W);
  Island island(lies.graph(near, reach), 0);
  for (int i = 0; i < 4; ++i) CHECK(island.allows_impact());
  CHECK_FALSE(island.allows_impact());
  Island part = island.components().at(0);
  CHECK_FALSE(part.allows_impact());  // components and merged islands remember
  Island other(lies.graph(near, reach), 0);
  other.absorb(part);
  other.sleep();
  other.end_step(1);
  CHECK(other.allows_impact());
}

TEST_CASE("island: a changed velocity lets contact events be emitted again") {
  const IslandBodies lies({ball(1, {0, 0, 1}, still, {}), table()}, still);
  Island island(lies.graph(near, reach), 0);
  island.graph().contact_pairs()[0].emitted = true;
  island.set_velocity(0, {{0, 0, 5}, still});
  CHECK_FALSE(island.graph().contact_pairs()[0].emitted);
  island.begin_step(1, 0.5);
  island.end_step(island.until());
  CHECK(island.graph().state(0).velocity.v_WBcm.z() == Approx(5));
}

}  // namespace
}  // namespace touchstone::fast::simulation
