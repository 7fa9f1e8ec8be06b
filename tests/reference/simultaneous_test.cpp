#include "reference/simultaneous.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/catch.h"
#include "tests/reference/exact_text.h"
#include "tests/reference/moving_scenes.h"

// Expected values are fractions that were computed on paper.
namespace touchstone::tests {
namespace {

using reference::approaching_regions;
using reference::compression;
using reference::ContactRegion;
using reference::ExactVec3;
using reference::RegionImpulse;

/// A cube of half side 1 and mass 1 with moments 1 on a table. u = v_z + y w_x - x w_y at its bottom.
Scene cube_on_table(const Velocity& V) {
  Scene scene;
  scene.bodies = {body(Box{Vec3(1, 1, 1)}, Vec3(0, 0, 1)), body(Box{Vec3(8, 8, 1)}, Vec3(0, 0, -1))};
  scene.bodies[0].mass = round_mass();
  scene.bodies[0].velocity = V;
  scene.bodies[1].mass = Fixed{};
  return moving_scene(scene, 1);
}

TEST_CASE("The region of a cube on a table is its bottom") {
  const auto regions = approaching_regions(cube_on_table({Vec3(0, 0, -1), Vec3(0, 0, 0)}), 0, 1, 0);
  REQUIRE(regions.size() == 1);
  const ContactRegion* region = &regions[0];
  CHECK(region->nhat_BA_W == Vec3(0, 0, 1));
  for (const Vec3& corner : {Vec3(1, 1, 0), Vec3(1, -1, 0), Vec3(-1, 1, 0), Vec3(-1, -1, 0)})
    CHECK(std::ranges::count(region->points_W, corner) > 0);
  for (const Vec3& p : region->points_W) CHECK((std::abs(p.x()) <= 1 && std::abs(p.y()) <= 1 && p.z() == 0));
}

TEST_CASE("There is no region where nothing approaches") {
  CHECK(approaching_regions(cube_on_table({Vec3(0, 0, 0), Vec3(0, 0, 0)}), 0, 1, 0).empty());
  CHECK(approaching_regions(cube_on_table({Vec3(1, 0, 1), Vec3(0, 0, 0)}), 0, 1, 0).empty());
}

RegionImpulse pressed(const Velocity& V) {
  const Scene scene = cube_on_table(V);
  return compression(scene, approaching_regions(scene, 0, 1, 0)).value().front();
}

TEST_CASE("A cube that lands flat presses such that no corner approaches") {
  const RegionImpulse still = pressed({Vec3(0, 0, -1), Vec3(0, 0, 0)});
  CHECK(text(still.P_A_W) == "0, 0, 1");
  CHECK(still.centre_W == Vec3(0, 0, 0));
  CHECK(text(still.changes[0].v_WBcm) == "0, 0, 1");
  CHECK(text(still.changes[0].w_WB) == "0, 0, 0");
  CHECK(text(still.changes[1].v_WBcm) == "0, 0, 0");

  // w_x = 1/4: u = -3/4 at y = 1 and -5/4 at y = -1. Both edges press, and all motion stops: P = 1, torque -1/4.
  const RegionImpulse turning = pressed({Vec3(0, 0, -1), Vec3(0.25, 0, 0)});
  CHECK(text(turning.P_A_W) == "0, 0, 1");
  CHECK(turning.centre_W == Vec3(0, -0.25, 0));
  CHECK(text(turning.changes[0].w_WB) == "-1/4, 0, 0");

  // w_x = 4: only y = -1 approaches, with u = -5, and K = 2 there. At y = 1 u = 3 + 5/2 - 5/2.
  const RegionImpulse edge = pressed({Vec3(0, 0, -1), Vec3(4, 0, 0)});
  CHECK(text(edge.P_A_W) == "0, 0, 5/2");
  CHECK(edge.centre_W == Vec3(0, -1, 0));
  CHECK(text(edge.changes[0].w_WB) == "-5/2, 0, 0");
}

/// Unit balls of mass 1 at these places; only their velocities and the regions matter.
Scene balls(const std::vector<Vec3>& places, const Vec3& v) {
  Scene scene;
  for (const Vec3& p : places) {
    scene.bodies.push_back(body(Sphere{1}, p));
    scene.bodies.back().mass = round_mass();
  }
  scene.bodies.front().velocity.v_WBcm = v;
  return scene;
}

TEST_CASE("A ball that hits two at once") {
  const Scene scene = balls({Vec3(0, 0, 0), Vec3(4, 3, 0), Vec3(4, -3, 0)}, Vec3(1, 0, 0));
  // u = N·(v0 - v1) with N = (-4, -+3). Impulses p N slow ball 0 to 1 - 8p and give 4p to the others:
  // -4 (1 - 8p) + 25p = 0, p = 4/57.
  const auto both =
      compression(scene, {{0, 1, Vec3(-4, -3, 0), {Vec3(2, 1.5, 0)}}, {0, 2, Vec3(-4, 3, 0), {Vec3(2, -1.5, 0)}}})
          .value();
  CHECK(text(both[0].changes[0].v_WBcm) == "-16/57, -4/19, 0");
  CHECK(text(both[1].changes[0].v_WBcm) == "-16/57, 4/19, 0");
  CHECK(text(both[0].changes[1].v_WBcm) == "16/57, 4/19, 0");
}

TEST_CASE("Of two contacts one presses less since the other takes part, or not at all") {
  // In line: 1 hits 2, which touches 3. Compression alone makes all three as fast: (1/3, 1/3, 1/3).
  const Scene row = balls({Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(4, 0, 0)}, Vec3(1, 0, 0));
  const Vec3 n(-1, 0, 0);
  const auto rows = compression(row, {{0, 1, n, {Vec3(1, 0, 0)}}, {1, 2, n, {Vec3(3, 0, 0)}}}).value();
  CHECK(text(rows[0].P_A_W) == "-2/3, 0, 0");
  CHECK(text(rows[1].P_A_W) == "-1/3, 0, 0");
  // A wedge of two planes with normals (1, 0) and (1, 2): the ball hits the second so fast that it leaves the first.
  Scene wedge = balls({Vec3(0, 0, 0), Vec3(-1, 0, 0), Vec3(-1, -1, 0)}, Vec3(-1, -4, 0));
  for (const std::size_t k : {1, 2}) wedge.bodies[k].mass = Fixed{};
  const auto planes =
      compression(wedge, {{0, 1, Vec3(1, 0, 0), {Vec3(0, 0, 0)}}, {0, 2, Vec3(1, 2, 0), {Vec3(0, 0, 0)}}}).value();
  // p = 9/5 along (1, 2): v = (4/5, -2/5).
  CHECK(text(planes[0].P_A_W) == "0, 0, 0");
  CHECK(text(planes[1].P_A_W) == "9/5, 18/5, 0");
}

TEST_CASE("A body between two that come nearer is clamped") {
  Scene scene = balls({Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(4, 0, 0)}, Vec3(1, 0, 0));
  scene.bodies[0].mass = scene.bodies[2].mass = Fixed{};
  scene.bodies[2].velocity.v_WBcm = {-1, 0, 0};
  const Vec3 n(-1, 0, 0);
  CHECK_FALSE(compression(scene, {{0, 1, n, {Vec3(1, 0, 0)}}, {1, 2, n, {Vec3(3, 0, 0)}}}));
}

}  // namespace
}  // namespace touchstone::tests
