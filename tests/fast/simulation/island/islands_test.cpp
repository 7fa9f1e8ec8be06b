// Which island a body is in, and which island is next.
#include "fast/simulation/island/islands.h"

#include "tests/catch.h"
#include "tests/fast/simulation/island/island_bodies.h"

namespace touchstone::fast::simulation {
namespace {

/// A table (0) and three balls on it, far apart.
struct Balls {
  Balls()
      : scene(moving_scene(
            {table(), ball(1, {0, 0, 1}, still, {}), ball(1, {9, 0, 1}, still, {}), ball(1, {20, 0, 1}, {0, 0, 2}, {})},
            still, {1})),
        world(scene),
        islands(world),
        bodies(scene.bodies, still) {}

  /// The island of one ball, with the table.
  Island island(BodyId id) const {
    ContactGraph graph(0x1p-10, 0.125);
    graph.add(bodies[0]);
    graph.add(bodies[id]);
    graph.link(0, id);
    return {graph, 0};
  }

  Scene scene;
  World world;
  Islands islands;
  IslandBodies bodies;
};

TEST_CASE("islands: each body that moves is in one at most, a fixed one in none") {
  Balls balls;
  balls.islands.insert(balls.island(2));
  balls.islands.insert(balls.island(1));
  CHECK(balls.islands.of(0) == nullptr);
  CHECK(balls.islands.of(3) == nullptr);
  REQUIRE(balls.islands.of(1) != nullptr);
  CHECK(balls.islands.of(1)->graph().key() == 1);
  CHECK(balls.islands.of(2)->graph().key() == 2);
  CHECK(balls.islands.follows_steps(0));  // it is fixed
  CHECK(balls.islands.follows_steps(1));
  CHECK_FALSE(balls.islands.follows_steps(3));
  CHECK(balls.islands.all().begin()->first == 1);
  const Island taken = balls.islands.take(1);
  CHECK(taken.graph().has(1));
  CHECK(balls.islands.of(1) == nullptr);
  CHECK(balls.islands.of(2) != nullptr);
}

TEST_CASE("islands: the state of a body is its island's, or that on its trajectory now") {
  Balls balls;
  balls.islands.insert(balls.island(1));
  balls.islands.of(1)->set_velocity(1, {{7, 0, 0}, still});
  balls.world.advance_to(0.5);
  CHECK(balls.islands.state(1).velocity.v_WBcm == Vec3(7, 0, 0));
  CHECK(balls.islands.state(3).X_WB.p_WB == Vec3(20, 0, 2));
}

TEST_CASE("islands: those that wait begin in the order of their bodies, the earliest end is first") {
  Balls balls;
  CHECK(balls.islands.next_waiting() == nullptr);
  CHECK(balls.islands.first_to_finish() == nullptr);
  for (const BodyId id : {3u, 2u, 1u}) balls.islands.insert(balls.island(id));
  CHECK(balls.islands.next_waiting() == balls.islands.of(1));
  CHECK(balls.islands.first_to_finish() == nullptr);
  balls.islands.of(1)->sleep();
  CHECK(balls.islands.next_waiting() == balls.islands.of(2));
  balls.islands.of(2)->begin_step(1, 0.5);
  balls.islands.of(3)->begin_step(1, 0.25);
  CHECK(balls.islands.next_waiting() == nullptr);
  CHECK(balls.islands.first_to_finish() == balls.islands.of(3));
}

}  // namespace
}  // namespace touchstone::fast::simulation
