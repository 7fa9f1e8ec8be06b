// A brick and a ball on the tiles of a floor, and at parts of it that are no tiles.
#include "fast/simulation/island/shared_normal.h"

#include "tests/catch.h"
#include "tests/fast/simulation/island/island_bodies.h"

namespace touchstone::fast::simulation {
namespace {

Part box_part(const Vec3& half, const Vec3& p) { return {{p, {}}, Box{half}}; }

Body compound(const std::vector<Part>& parts) {
  Body body = table();
  body.X_WB = {};
  body.shape = Compound{parts};
  return body;
}

/// Its upper face is at z = 0, and its parts meet at x = 0; the right one is higher by `step`.
Body floor_of_two(double step = 0) {
  return compound({box_part({4, 4, 1}, {-4, 0, -1}), box_part({4, 4, 1}, {4, 0, step - 1})});
}

ContactGraph graph_of(const Body& moving, const Body& fixed) {
  return IslandBodies({moving, fixed}, g_W).graph(near, reach);
}

TEST_CASE("shared normal: a brick is not stopped by the side of the tile that it comes to") {
  const ContactGraph graph = graph_of(brick({1, 1, 1}, {-1 - near / 2, 0, 1}, {}), floor_of_two());
  REQUIRE(graph.contact_pairs().size() == 2);
  for (const ContactPair& pair : graph.contact_pairs()) CHECK(pair.nhat_BA_W == up);
  CHECK(graph.contact_pairs()[0].contact_points.size() == 4);
  CHECK_FALSE(graph.contact_pairs()[0].shared);
  CHECK(graph.contact_pairs()[1].contact_points.empty());
  CHECK(graph.contact_pairs()[1].shared);
  CHECK_FALSE(graph.contact_pairs()[1].touched);
}

TEST_CASE("shared normal: a brick over both tiles touches both") {
  const ContactGraph graph = graph_of(brick({1, 1, 1}, {-0.5, 0, 1}, {}), floor_of_two());
  REQUIRE(graph.contact_pairs().size() == 2);
  for (const ContactPair& pair : graph.contact_pairs()) {
    CHECK(pair.nhat_BA_W == up);
    CHECK(pair.contact_points.size() == 4);
    CHECK(pair.touched);
  }
}

// The tile beyond the corner could take the normals of its neighbours, too, which are those of their sides.
TEST_CASE("shared normal: a brick whose corner is over the corner of four tiles is stopped by none of them") {
  std::vector<Part> tiles;
  for (const double x : {-4.0, 4.0}) {
    for (const double y : {-4.0, 4.0}) tiles.push_back(box_part({4, 4, 1}, {x, y, -1}));
  }
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const ContactGraph graph = graph_of(brick({1, 1, 1}, {x, y, 1}, {}), compound(tiles));
      REQUIRE(graph.contact_pairs().size() == 4);
      for (const ContactPair& pair : graph.contact_pairs()) CHECK(pair.nhat_BA_W == up);
    }
  }
}

TEST_CASE("shared normal: a tile that is higher stops the brick, and so does a wall") {
  const Body wall = compound({box_part({8, 4, 1}, {0, 0, -1}), box_part({1, 4, 4}, {1, 0, 2})});
  for (const Body& fixed : {floor_of_two(0.0625), wall}) {
    const ContactGraph graph = graph_of(brick({1, 1, 1}, {-1, 0, 1}, {}), fixed);
    REQUIRE(graph.contact_pairs().size() == 2);
    CHECK(graph.contact_pairs()[0].nhat_BA_W == up);
    CHECK(graph.contact_pairs()[1].nhat_BA_W == Vec3(-1, 0, 0));
    CHECK(graph.contact_pairs()[1].contact_points.size() >= 2);
    CHECK_FALSE(graph.contact_pairs()[1].shared);
  }
}

// The ball's centre is d before the seam, so the edge there is √(1 + d²) − 1 away from it, which is less than `near`.
TEST_CASE("shared normal: a ball is not tilted by the edge of the tile that it comes to") {
  const double d = 0x1p-6;
  REQUIRE(d * d / 2 < near);
  const ContactGraph graph = graph_of(ball(1, {-d, 0, 1}, still, {}), floor_of_two());
  REQUIRE(graph.contact_pairs().size() == 2);
  for (const ContactPair& pair : graph.contact_pairs()) CHECK(pair.nhat_BA_W == up);
  CHECK(graph.contact_pairs()[0].contact_points.size() == 1);
  CHECK(graph.contact_pairs()[1].contact_points.empty());
}

TEST_CASE("shared normal: a lone pair remembers that it has touched, and where") {
  const auto at = [](double height) { return IslandBodies({brick({1, 1, 1}, {0, 0, 1 + height}, {}), table()}, g_W); };
  const IslandBodies within = at(0.0625), on = at(0);
  std::vector<ContactPair> pair{{0, 1}};
  const auto renew = [&](const IslandBodies& bodies) {
    REQUIRE(update(pair[0], bodies[0], bodies[1], near, reach));
    share_normals(pair, bodies[0], bodies[1], near);
  };
  renew(within);
  CHECK_FALSE(pair[0].touched);
  renew(on);
  CHECK(pair[0].touched);
  CHECK(pair[0].p_WC == candidate_at(pair[0], pair[0].contact_points.front(), on[0], on[1]).touch.p_WC);
  renew(within);
  CHECK(pair[0].contact_points.empty());
  CHECK(pair[0].touched);
}

// v = 3 − μ g t, as on a floor of one piece.
TEST_CASE("shared normal: a brick slides over a seam as friction has it, and a ball over many") {
  Body slider = brick({0.5, 0.5, 0.5}, {-1, 0, 0.5}, {0.5, 0.125});
  slider.velocity.v_WBcm = {3, 1, 0};
  Scene scene = moving_scene({slider, floor_of_two()}, g_W, {1});
  for (Body& body : scene.bodies) body.material = {0, 0.125};
  const Simulated slides = simulate(scene);
  const Vec3 along = Vec3(3, 1, 0).normalized();
  REQUIRE(slides.trajectory.states.size() == 1);
  const State& end = slides.trajectory.states[0][0];
  CHECK((end.velocity.v_WBcm - (Vec3(3, 1, 0) - 1.25 * along)).norm() < 1e-9);
  CHECK((end.X_WB.p_WB - (slider.X_WB.p_WB + Vec3(3, 1, 0) - 0.625 * along)).norm() < 1e-9);
  CHECK(end.velocity.w_WB.norm() < 1e-9);

  std::vector<Part> tiles;
  for (int i = -8; i < 8; ++i) tiles.push_back(box_part({0.25, 4, 1}, {0.5 * i + 0.25, 0, -1}));
  scene.bodies = {ball(0.5, {-3, 0, 0.5}, {5, 0, 0}, {0, 1}), compound(tiles)};
  scene.bodies[0].velocity.w_WB = {0, 10, 0};
  const Simulated rolls = simulate(scene);
  REQUIRE(rolls.trajectory.states.size() == 1);
  CHECK((rolls.trajectory.states[0][0].X_WB.p_WB - Vec3(2, 0, 0.5)).norm() < 1e-9);
  CHECK((rolls.trajectory.states[0][0].velocity.w_WB - Vec3(0, 10, 0)).norm() < 1e-9);
  for (const Event& event : *rolls.trajectory.events) CHECK(event.kind == Event::Kind::contact);
}

}  // namespace
}  // namespace touchstone::fast::simulation
