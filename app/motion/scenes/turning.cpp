// Rotating bodies, without torque or on a table.
#include "app/motion/scenes/build.h"
#include "app/motion/scenes/list.h"
#include "app/motion/scenes/truths.h"
#include "reference/validity.h"

namespace touchstone::app {
namespace {

/// The middle axis is unstable: the top tips over again and again, and conserves T and L.
MotionScene top(const std::string& name, const Vec3& w, double step) {
  const Scene scene = scene_of(name, {block({0.375, 0.25, 0.125}, Vec3::Zero(), {{0, 0, 0}, w})},
                               {.g = 0, .step = step, .samples = 20});
  return {scene, "free turn about the middle axis: T and L stay; relative to them", off_free_turn(scene)};
}

MotionScene needle() {
  Body needle = block({1, 0x1p-9, 0x1p-9}, {0, 0, 2}, {{0, 0, 0}, {0.5, 2, 0}});
  const Scene scene = scene_of("needle", {needle, table()}, {.restitution = 1, .step = 0.125, .samples = 24});
  return {scene, "a needle 512 times as long as wide, e = 1, no friction: energy stays; relative to it",
          off_energy(scene)};
}

/// Corners of a regular polygon of 4·2ⁿ sides, by halving angles.
std::vector<Vec3> circle(int halvings) {
  std::vector<Vec3> corners{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  for (; halvings > 0; --halvings) {
    std::vector<Vec3> finer;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      finer.push_back(corners[k]);
      finer.push_back((corners[k] + corners[(k + 1) % corners.size()]).normalized());
    }
    corners = finer;
  }
  return corners;
}

MotionScene coin() {
  Polytope disc;
  for (const double z : {-0.0625, 0.0625}) {
    for (const Vec3& corner : circle(2)) disc.vertices.push_back({corner.x(), corner.y(), z});
  }
  Body body = body_of(disc, {0, 0, 0.75}, {{0, 0, 0}, {0, 0, 6}});
  body.X_WB.q_WB = {4, 1, 0, 0};
  const Scene scene = reference::completed(
      scene_of("coin", {body, table()}, {.restitution = 0.25, .friction = 0.25, .step = 0.125, .samples = 16}));
  return {scene, "a coin of 16 sides falls and wobbles: energy never rises; relative to it", gained_energy(scene)};
}

}  // namespace

std::vector<MotionScene> turning_scenes() {
  return {top("top_middle_axis", {0.0625, 8, 0.0625}, 0.5), top("top_spun_1e4", {16, 1e4, 16}, 0.0625), needle(),
          coin()};
}

}  // namespace touchstone::app
