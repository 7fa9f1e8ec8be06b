// Momentum on a grid: the total keeps every bit, whatever the impulses.
#include "fast/simulation/exact_momentum.h"

#include "model/input_error.h"
#include "tests/catch.h"
#include "tests/fast/simulation/scenes.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::fast::simulation {
namespace {

TEST_CASE("exact momentum: impulses are rounded to the grid, and velocities follow from momenta") {
  // 16 J in a body of 2 kg are at most 8 kg m/s; the grid is 2^-49 of that.
  const Scene scene =
      moving_scene({ball(1, {0, 0, 0}, {4, 0, 0}, {}, 2), ball(1, {9, 0, 0}, Vec3::Zero(), {}, 1)}, Vec3::Zero(), {1});
  const World world(scene);
  ExactMomentum exact(world);
  CHECK(exact.before() == std::vector<Vec3>{{8, 0, 0}, {0, 0, 0}});
  ImpactResult result;
  result.P_A_W = {-1 - 0.75 * 0x1p-46, 0x1p-48, 0x1p-47};
  exact.apply(0, 1, result);
  CHECK(result.P_A_W == Vec3(-1 - 0x1p-46, 0, 0x1p-46));
  CHECK(exact.now()[0] == Vec3(7 - 0x1p-46, 0, 0x1p-46));
  CHECK(exact.now()[1] == Vec3(1 + 0x1p-46, 0, -0x1p-46));
  CHECK(result.after_a.v_WBcm == exact.now()[0] / 2);
  CHECK(result.after_b.v_WBcm == exact.now()[1]);
  CHECK(exact.before()[0] == Vec3(8, 0, 0));
}

TEST_CASE("exact momentum: the sum has the same bits after any impulses") {
  tests::Dice dice(7);
  std::vector<Body> bodies;
  for (int i = 0; i < 5; ++i) bodies.push_back(ball(1, Vec3(3.0 * i, 0, 0), dice.in_cube(), {}, 0.1 + dice.unit()));
  const Scene scene = moving_scene(bodies, Vec3::Zero(), {1});
  const World world(scene);
  ExactMomentum exact(world);
  const auto sum = [](const std::vector<Vec3>& all) {
    Vec3 total = Vec3::Zero();
    for (const Vec3& one : all) total += one;
    return total;
  };
  for (int k = 0; k < 200; ++k) {
    ImpactResult result;
    result.P_A_W = 0.1 * dice.in_cube();
    const int b = dice.between(1, 4);
    exact.apply(static_cast<BodyId>(dice.between(0, b - 1)), static_cast<BodyId>(b), result);
    REQUIRE(sum(exact.now()) == sum(exact.before()));
  }
}

TEST_CASE("exact momentum: a fixed body has none, and what changes momentum is refused") {
  Scene scene = moving_scene({ball(1, {0, 0, 3}, {0, 0, -1}, {}), table()}, Vec3::Zero(), {1});
  CHECK(ExactMomentum(World(scene)).before()[1] == Vec3::Zero());
  scene.motion->forces = {{0.5, 0, {1, 0, 0}}};
  CHECK_THROWS_AS(ExactMomentum(World(scene)), InputError);
  scene.motion->forces.clear();
  scene.gravity = {0, 0, -10};
  CHECK_THROWS_AS(ExactMomentum(World(scene)), InputError);
}

}  // namespace
}  // namespace touchstone::fast::simulation
