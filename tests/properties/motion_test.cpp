// Transforms of scenes are exact, and return nothing where they would have to round.
#include "properties/transforms/body.h"
#include "properties/transforms/exact_sum.h"
#include "properties/transforms/scene.h"
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

TEST_CASE("motions of an impact: its point, normal and velocities go with the bodies") {
  Scene scene = tests::pair("an impact", tests::body(Sphere{1}, {0, 0, 3}), tests::body(Box{Vec3(2, 3, 1)}, {1, 2, 1}));
  scene.bodies[0].velocity = {{1, 2, -3}, {4, 5, 6}};
  MassProperties given;
  given.mass = 2;
  given.p_BBcm = {1, 2, 3};
  given.I_BBcm_B << 5, 1, 2, 1, 6, 3, 2, 3, 7;
  scene.bodies[1].mass = given;
  scene.contact = Contact{{0, 0, 2}, {0, 0, 1}, Law::stronge, 0.5, 0.25};

  CHECK(swapped(scene).contact->nhat_BA_W == Vec3(0, 0, -1));
  CHECK(translated(scene)->contact->p_WC - scene.contact->p_WC == translation_between(scene, *translated(scene)));
  CHECK(turned(scene)->contact->p_WC == Vec3(2, 0, 0));
  CHECK(turned(scene)->contact->nhat_BA_W == Vec3(1, 0, 0));
  CHECK(half_turned(scene).contact->p_WC == Vec3(0, 0, -2));
  CHECK(half_turned(scene).contact->nhat_BA_W == Vec3(0, 0, -1));

  CHECK(mirrored(*mirrored(scene)) == scene);
  CHECK(mirrored(scene)->bodies[0].velocity == Velocity{{-1, 2, -3}, {4, -5, -6}});
  CHECK(std::get<MassProperties>(mirrored(scene)->bodies[1].mass).I_BBcm_B(0, 1) == -1);
  CHECK(std::get<MassProperties>(mirrored(scene)->bodies[1].mass).I_BBcm_B(1, 2) == 3);
  CHECK_FALSE(mirrored(tests::scene("polytopes deep in each other")));

  const Scene larger = *scaled(scene, 2);
  CHECK(larger.contact->p_WC == Vec3(0, 0, 8));
  CHECK(larger.bodies[0].velocity == Velocity{{4, 8, -12}, {4, 5, 6}});
  CHECK(std::get<MassProperties>(larger.bodies[1].mass).mass == 128);
  CHECK(std::get<MassProperties>(larger.bodies[1].mass).I_BBcm_B(0, 0) == 5 * 1024);

  CHECK(sped_up(*sped_up(scene, 20), -20) == scene);
  CHECK_FALSE(sped_up(scene, 1024));
  const Scene flying = *boosted(scene);
  CHECK(flying.bodies[0].velocity.v_WBcm - scene.bodies[0].velocity.v_WBcm == flying.bodies[1].velocity.v_WBcm);
  CHECK(flying.bodies[1].velocity.v_WBcm != Vec3::Zero());
  scene.bodies[1].mass = Fixed{};
  CHECK_FALSE(boosted(scene));
}
