// When an island sleeps, what removing approach does, and energy by hand.
#include "fast/simulation/island/island_rest.h"

#include "tests/catch.h"
#include "tests/fast/simulation/island/island_bodies.h"

namespace touchstone::fast::simulation {
namespace {

TEST_CASE("island rest: an island sleeps if it is slow and contacts carry the weight") {
  const auto sleeps = [](const Body& body, const Vec3& acceleration) {
    const IslandBodies bodies({body, table()}, acceleration);
    ContactGraph graph = bodies.graph(near, reach);
    const bool passes = rest_test(graph, 0.5);
    CHECK(graph.state(0).velocity.v_WBcm == (passes ? still : body.velocity.v_WBcm));
    return passes;
  };
  const Material rough{0, 0.5};
  CHECK(sleeps(ball(1, {0, 0, 1}, {0.25, 0, 0}, rough), g_W));
  CHECK_FALSE(sleeps(ball(1, {0, 0, 1}, {0.75, 0, 0}, rough), g_W));
  CHECK_FALSE(sleeps(ball(1, {0, 0, 9}, still, {}), g_W));
  CHECK(sleeps(ball(1, {0, 0, 9}, still, {}), still));  // nothing to carry
  // A block on a slope of 2 to 10 needs μ ≥ 0.2.
  CHECK(sleeps(brick({1, 1, 1}, {0, 0, 1}, {0, 0.21}), {2, 0, -10}));
  CHECK_FALSE(sleeps(brick({1, 1, 1}, {0, 0, 1}, {0, 0.19}), {2, 0, -10}));
}

// On ice it would lose momentum that nothing takes.
TEST_CASE("island rest: what no friction brakes sleeps only without any speed") {
  for (const double speed : {0.0, 0.25}) {
    const IslandBodies bodies({ball(1, {0, 0, 1}, {speed, 0, 0}, {}), table()}, g_W);
    ContactGraph graph = bodies.graph(near, reach);
    CHECK(rest_test(graph, 0.5) == (speed == 0));
  }
}

TEST_CASE("island rest: bodies that touch and move on together do not sleep, rough as they are, if none is fixed") {
  const Material rough{0, 0.5};
  const auto sleeps = [&](double speed) {
    const IslandBodies bodies({ball(1, {-1, 0, 0}, {speed, 0, 0}, rough), ball(1, {1, 0, 0}, {speed, 0, 0}, rough)},
                              still);
    ContactGraph graph = bodies.graph(near, reach);
    return rest_test(graph, 0.5);
  };
  CHECK(sleeps(0));
  CHECK_FALSE(sleeps(0.25));
}

TEST_CASE("island rest: rough bodies on each other do not sleep on ice, unless one of them is held") {
  const Material rough{0, 0.5}, ice{0, 0};
  for (const bool held : {false, true}) {
    Body under = table();
    if (!held) under.material = ice;
    const IslandBodies bodies({brick({1, 1, 1}, {0, 0, 1}, rough), brick({1, 1, 1}, {0, 0, 3}, rough), under}, g_W);
    ContactGraph graph = bodies.graph(near, reach);
    for (const BodyId id : {0, 1}) graph.body(id).step_body.state.velocity.v_WBcm = {0.25, 0, 0};
    CHECK(rest_test(graph, 0.5) == held);
  }
}

TEST_CASE("island rest: turning counts as fast as the farthest corner, and a moving support never sleeps") {
  Body box = brick({1, 2, 2}, {0, 0, 2}, {});  // radius 3
  box.velocity.w_WB = {0, 0, 0.125};
  const IslandBodies turning({box, table()}, g_W);
  ContactGraph graph = turning.graph(near, reach);
  CHECK_FALSE(rest_test(graph, 0.25));
  Body moving = table();
  moving.velocity.v_WBcm = {1e-9, 0, 0};
  const IslandBodies on_moving({ball(1, {0, 0, 1}, still, {}), moving}, g_W);
  ContactGraph carried = on_moving.graph(near, reach);
  CHECK_FALSE(rest_test(carried, 0.25));
}

TEST_CASE("island rest: approach is removed without restitution, separation is kept") {
  const IslandBodies down({ball(1, {0, 0, 1}, {0, 0, -3}, {1, 0}), table()}, g_W);
  ContactGraph falls = down.graph(near, reach);
  remove_approach(falls);
  CHECK(falls.state(0).velocity.v_WBcm.norm() < 1e-12);
  const IslandBodies away({ball(1, {0, 0, 1}, {0, 0, 3}, {1, 0}), table()}, g_W);
  ContactGraph rises = away.graph(near, reach);
  remove_approach(rises);
  CHECK(rises.state(0).velocity.v_WBcm == Vec3(0, 0, 3));
}

TEST_CASE("island rest: kinetic and potential energy of what is not fixed") {
  Body body = ball(1, {0, 0, 5}, {3, 0, 0}, {}, 2);
  body.velocity.w_WB = {0, 0, 10};
  const IslandBodies bodies({body, table()}, g_W);
  const ContactGraph graph = bodies.graph(near, reach);
  CHECK(energy(graph) == Approx(9 + 0.5 * 0.8 * 100 + 2 * 10 * 5));
}

}  // namespace
}  // namespace touchstone::fast::simulation
