// Impulses of applied forces that change and that end, on paper.
#include "properties/cases/applied_impulse.h"

#include "tests/catch.h"

namespace touchstone::properties {
namespace {

TEST_CASE("applied impulses: each body has the length of its own, also where two cancel") {
  Scene scene;
  scene.bodies.resize(3);
  scene.motion.emplace();
  scene.motion->forces = {{1, 1, {3, 4, 0}}, {2, 2, {0, 0, -2}}, {3, 1, {-3, -4, 0}}, {4, 2, {0, 0, 0}}};
  const AppliedImpulse sum = applied_until(scene, 5);
  CHECK(sum.total == Vec3(0, 0, -4));                     // 2 (3, 4, 0) − 2 (3, 4, 0) + 2 (0, 0, −2)
  CHECK(sum.of_bodies == std::vector<double>{0, 20, 4});  // 2 · 5 + 2 · 5, 2 · 2
  CHECK(sum.changes == 5 + 2 + 10 + 2);
  CHECK(applied_until(scene, 2.5).of_bodies == std::vector<double>{0, 7.5, 1});
}

}  // namespace
}  // namespace touchstone::properties
