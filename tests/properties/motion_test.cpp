// Motions lose no bit, and say so where they would.
#include "properties/motion.h"

#include "properties/body_motion.h"
#include "properties/exact_sum.h"
#include "tests/catch.h"
#include "tests/properties/scenes.h"

using namespace touchstone;
using namespace touchstone::properties;

TEST_CASE("exact_sum: the sum, or nothing") {
  CHECK(exact_sum({1.0, 0x1p-52}) == 1 + 0x1p-52);
  CHECK(exact_sum({1.0, 0x1p-53}) == std::nullopt);
  CHECK(exact_sum({0x1p1023, 0x1p1023}) == std::nullopt);
  CHECK(exact_sum({0.1, 0.2}) == std::nullopt);
}

TEST_CASE("twice swapped, twice relabelled, thrice turned, twice half turned: the scene again") {
  for (const Scene& scene : tests::scenes()) {
    INFO(scene.name);
    CHECK(swapped(swapped(scene)) == scene);
    if (const auto once = relabelled(scene)) CHECK(relabelled(*once) == scene);
    const Scene half = half_turned(half_turned(scene));
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const Quaternion q = scene.bodies[i].X_WB.q_WB, r = half.bodies[i].X_WB.q_WB;
      CHECK(half.bodies[i].X_WB.p_WB == scene.bodies[i].X_WB.p_WB);
      CHECK(r == Quaternion{-q.w, -q.x, -q.y, -q.z});  // (0,1,0,0)² = -1: the same rotation
    }
    const auto thrice = turned(*turned(*turned(scene)));
    REQUIRE(thrice);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const Quaternion q = scene.bodies[i].X_WB.q_WB;
      CHECK(thrice->bodies[i].X_WB.p_WB == scene.bodies[i].X_WB.p_WB);
      CHECK(thrice->bodies[i].X_WB.q_WB == Quaternion{-8 * q.w, -8 * q.x, -8 * q.y, -8 * q.z});  // (1,1,1,1)³ = -8
    }
  }
}

TEST_CASE("translated: exactly by one vector, or not at all") {
  for (const Scene& scene : tests::scenes()) {
    const auto moved = translated(scene);
    REQUIRE(moved);
    const Vec3 t = translation_between(scene, *moved);
    CHECK(t != Vec3::Zero());
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      CHECK(moved->bodies[i].X_WB.p_WB - t == scene.bodies[i].X_WB.p_WB);
    }
  }
  Scene uneven = tests::scene("cubes apart along y");
  uneven.bodies[0].X_WB.p_WB = Vec3(0.1, 0.1, 0.1);
  uneven.bodies[1].X_WB.p_WB = Vec3(1e9 / 3, 0, 0);
  CHECK_FALSE(translated(uneven));
}

TEST_CASE("scaled: all lengths, and nothing that overflows or vanishes") {
  const Scene& scene = tests::scene("two parts against one");
  const auto larger = scaled(scene, 20);
  REQUIRE(larger);
  CHECK(scaled(*larger, -20) == scene);
  CHECK_FALSE(scaled(scene, 1024));
  CHECK_FALSE(scaled(scene, -1080));
}

TEST_CASE("body motions: thrice turned is the same, a cube cannot be shifted, densities scale") {
  const Scene& solids = tests::scene("a needle");
  CHECK(turned_in_body(*turned_in_body(*turned_in_body(solids))) == solids);
  CHECK(shifted_in_body(solids));
  CHECK_FALSE(shifted_in_body(tests::scene("cubes apart along y")));
  CHECK(denser(*denser(solids, 3), -3) == solids);
  CHECK_FALSE(denser(solids, 1024));
}
