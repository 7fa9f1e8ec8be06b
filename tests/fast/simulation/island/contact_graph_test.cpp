// Which bodies contacts connect, and which leave.
#include "fast/simulation/island/contact_graph.h"

#include "tests/catch.h"
#include "tests/fast/simulation/island/island_bodies.h"

namespace touchstone::fast::simulation {
namespace {

Body ball_at(double x, double height, const Vec3& v = still) { return ball(1, {x, 0, 1 + height}, v, {}); }

std::vector<BodyId> ids(const ContactGraph& graph) {
  std::vector<BodyId> ids;
  for (const IslandBody& body : graph.bodies()) ids.push_back(body.id);
  return ids;
}

TEST_CASE("contact graph: bodies are sorted, and the key is the first that moves") {
  const IslandBodies bodies({table(), ball_at(0, 0), ball_at(9, 0)}, still);
  ContactGraph graph(near, reach);
  graph.add(bodies[2]);
  graph.add(bodies[0]);
  CHECK(ids(graph) == std::vector<BodyId>{0, 2});
  CHECK(graph.key() == 2);
  CHECK_FALSE(graph.has(1));
  graph.add(bodies[1]);
  CHECK(graph.has(1));
  CHECK(graph.key() == 1);
  CHECK(graph.index(2) == 2);
  CHECK(graph.state(2).X_WB.p_WB == Vec3(9, 0, 1));
}

TEST_CASE("contact graph: links bodies within reach") {
  const IslandBodies bodies({table(), ball_at(0, 0.0625), ball_at(9, 0.25)}, still);
  ContactGraph graph(near, reach);
  for (const BodyId id : {0u, 1u, 2u}) graph.add(bodies[id]);
  CHECK(graph.link(1, 0));
  CHECK_FALSE(graph.link(0, 2));
  CHECK(graph.connects(0, 1));
  CHECK(graph.connects(1, 0));
  CHECK_FALSE(graph.connects(0, 2));
  CHECK(graph.link(0, 1));
  CHECK(graph.contact_pairs().size() == 1);  // not twice
}

TEST_CASE("contact graph: takes over the greater distances of a graph that it absorbs") {
  const IslandBodies bodies({table(), ball_at(0, 0.5)}, still);
  ContactGraph coarse(0.5, 0.75), fine(near, reach);
  for (const BodyId id : {0u, 1u}) coarse.add(bodies[id]);
  CHECK(coarse.link(0, 1));
  fine.absorb(coarse);
  CHECK(fine.near() == 0.5);
  CHECK(fine.points().size() == 1);
  coarse.absorb(ContactGraph(near, reach));
  CHECK(coarse.near() == 0.5);
}

TEST_CASE("contact graph: links the parts that may come within reach in a step") {
  // Two balls of a dumbbell over a table: one touches, the other is 1 m above it.
  Body dumbbell;
  Compound balls;
  balls.parts.push_back({{{-2, 0, 0}, {}}, Sphere{1}});
  balls.parts.push_back({{{2, 0, 1}, {}}, Sphere{1}});
  dumbbell.shape = balls;
  dumbbell.X_WB.p_WB = {0, 0, 1};
  dumbbell.mass = MassProperties{1, still, Mat3::Identity()};
  dumbbell.velocity.v_WBcm = {0, 0, -2};
  const IslandBodies bodies({dumbbell, table()}, still);
  ContactGraph graph = bodies.graph(near, reach);
  CHECK(graph.contact_pairs().size() == 1);
  graph.link_parts(0.25);
  CHECK(graph.contact_pairs().size() == 1);
  graph.link_parts(0.5);
  CHECK(graph.contact_pairs().size() == 2);
}

TEST_CASE("contact graph: a fixed body connects no others") {
  const IslandBodies apart({table(), ball_at(0, 0), ball_at(9, 0), ball_at(20, 3)}, still);
  const std::vector<ContactGraph> two = apart.graph(near, reach).components();
  REQUIRE(two.size() == 2);  // the ball that touches nothing is left out
  CHECK(ids(two[0]) == std::vector<BodyId>{0, 1});
  CHECK(ids(two[1]) == std::vector<BodyId>{0, 2});
  const IslandBodies touching({table(), ball_at(0, 0), ball_at(2, 0)}, still);
  const std::vector<ContactGraph> one = touching.graph(near, reach).components();
  REQUIRE(one.size() == 1);
  CHECK(ids(one[0]) == std::vector<BodyId>{0, 1, 2});
  CHECK(one[0].contact_pairs().size() == 3);
}

TEST_CASE("contact graph: balls that touch are connected, whatever place the table has among the bodies") {
  const Body first = ball_at(0, 0), second = ball_at(2, 0), other = ball_at(20, 0);
  for (const auto& all :
       {std::vector<Body>{first, table(), second, other}, std::vector<Body>{first, second, table(), other}}) {
    const std::vector<ContactGraph> graphs = IslandBodies(all, still).graph(near, reach).components();
    REQUIRE(graphs.size() == 2);
    CHECK(ids(graphs[0]) == std::vector<BodyId>{0, 1, 2});
    CHECK(ids(graphs[1]).size() == 2);
  }
}

TEST_CASE("contact graph: absorbs another one without a body or pair twice") {
  const IslandBodies bodies({table(), ball_at(0, 0), ball_at(9, 0)}, still);
  std::vector<ContactGraph> parts = bodies.graph(near, reach).components();
  REQUIRE(parts.size() == 2);
  parts[1].absorb(parts[0]);
  CHECK(ids(parts[1]) == std::vector<BodyId>{0, 1, 2});
  REQUIRE(parts[1].contact_pairs().size() == 2);
  CHECK(parts[1].contact_pairs()[0].b == 1);
  CHECK(parts[1].contact_pairs()[1].b == 2);
}

TEST_CASE("contact graph: releases a body whose contacts separate faster than the limit, but not while one overlaps") {
  const auto released = [](double height, double speed) {
    const IslandBodies bodies({table(), ball_at(0, height, {0, 0, speed}), ball_at(9, 0)}, still);
    ContactGraph graph = bodies.graph(near, reach);
    const std::vector<ContactPair> out = graph.take_out_separating([](BodyId, BodyId) { return 0.5; });
    CHECK(graph.connects(0, 2));
    CHECK(graph.connects(0, 1) == out.empty());
    return out.size();
  };
  CHECK(released(0, 1) == 1);
  CHECK(released(0, 0.25) == 0);
  CHECK(released(-near / 4, 1) == 0);
}

TEST_CASE("contact graph: a pair that never touched is dropped without being reported") {
  const IslandBodies bodies({table(), ball_at(0, 0.0625)}, still);
  ContactGraph graph = bodies.graph(near, reach);
  REQUIRE(graph.contact_pairs().size() == 1);
  CHECK(graph.take_out_separating([](BodyId, BodyId) { return 0.5; }).empty());
  CHECK(graph.contact_pairs().empty());
}

TEST_CASE("contact graph: the fastest approach of all contact points") {
  const IslandBodies bodies({table(), ball_at(0, 0, {0, 0, -1}), ball_at(9, 0, {5, 0, -3})}, still);
  const std::optional<ImpactCandidate> found = fastest_approach(bodies.graph(near, reach).points());
  REQUIRE(found.has_value());
  CHECK(found->u_n == Approx(-3));
  CHECK(found->b == 2);
  const IslandBodies apart({table(), ball_at(0, 0.0625)}, still);
  CHECK_FALSE(fastest_approach(apart.graph(near, reach).points()).has_value());
}

TEST_CASE("contact graph: only the pairs of a body are emitted again") {
  const IslandBodies bodies({table(), ball_at(0, 0), ball_at(9, 0)}, still);
  ContactGraph graph = bodies.graph(near, reach);
  for (ContactPair& pair : graph.contact_pairs()) pair.emitted = true;
  graph.emit_again(2);
  CHECK(graph.contact_pairs()[0].emitted);
  CHECK_FALSE(graph.contact_pairs()[1].emitted);
}

// A ball on a table, a second one that comes down on it, and a third that comes down on the table.
TEST_CASE("contact graph: keeps a body that comes down on one in contact, but not one that is near a fixed one alone") {
  const Vec3 down(0, 0, -1);
  const IslandBodies bodies({table(), ball_at(0, 0), ball_at(0, 2.0625, down), ball_at(9, 0.0625, down)}, still);
  ContactGraph graph = bodies.graph(near, reach);
  REQUIRE(graph.contact_pairs().size() == 3);
  CHECK(graph.take_out_separating([](BodyId, BodyId) { return 0x1p-4; }).empty());
  CHECK(graph.connects(1, 2));
  CHECK_FALSE(graph.connects(0, 3));
}

}  // namespace
}  // namespace touchstone::fast::simulation
