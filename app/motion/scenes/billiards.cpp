// Balls of equal or very different mass that collide in free space.
#include <cmath>

#include "app/motion/scenes/build.h"
#include "app/motion/scenes/list.h"
#include "app/motion/scenes/pool_break_truth.h"
#include "app/motion/scenes/truths.h"

namespace touchstone::app {
namespace {

/// Velocities permute: each ball takes over the velocity, crosses its gap and passes it on; the last ball leaves.
MotionScene newtons_cradle() {
  std::vector<Body> bodies{ball(0.5, {-3, 0, 0}, {{1, 0, 0}, {0, 0, 0}})};
  for (int k = 0; k < 4; ++k) bodies.push_back(ball(0.5, {1.125 * k, 0, 0}));
  const Scene scene = scene_of("newtons_cradle", bodies, {.g = 0, .restitution = 1, .step = 0.25, .samples = 16});
  std::map<int, Path> paths;
  for (int k = 0; k < 5; ++k) {
    const Real from = bodies[static_cast<std::size_t>(k)].X_WB.p_WB.x();
    const Real starts = k == 0 ? 0 : 2 + 0.125 * (k - 1);
    const Real goes = k == 0 ? 2 : k == 4 ? INFINITY : 0.125;
    paths[k] = [=](Real t) { return Real3(from + std::clamp(t - starts, Real(0), goes), 0, 0); };
  }
  return {scene, "the speed is handed on from ball to ball; relative to their radius", off_paths(scene, paths, 0.5)};
}

/// Masses M = 10⁶ m. In X = √M x, Y = √m y the two gaps are one point that moves straight in a wedge of angle atan
/// √(m/M) and is reflected by its sides; unfolded, it moves straight for ever. It hits the sides 3141 times, the first
/// digits of π (Galperin 2003).
MotionScene pi_billiard() {
  const double M = 1e6, v = 1, small_gap = 1, big_gap = 2.5, r = 0.5;
  const Scene scene = scene_of(
      "pi_billiard",
      {weighed_ball(1, r, {small_gap + r, 0, 0}), weighed_ball(M, r, {big_gap + 3 * r, 0, 0}, {{-v, 0, 0}, {0, 0, 0}}),
       fixed_block({1, 8, 8}, {-1, 0, 0})},
      {.g = 0, .restitution = 1, .step = 0.125, .samples = 40});
  const Real root = std::sqrt(Real(M)), wedge = std::atan(1 / root);
  const auto gaps = [=](Real t) {
    const Real X = root * (big_gap - v * t), Y = small_gap;
    const Real angle = std::atan2(Y, X), sheet = std::floor(angle / wedge);
    const Real within = angle - sheet * wedge;
    const Real folded = std::fmod(sheet, 2) == 0 ? within : wedge - within;
    const Real radius = std::hypot(X, Y);
    return std::pair(radius * std::sin(folded), radius * std::cos(folded) / root);
  };
  const Path small = [=](Real t) { return Real3(gaps(t).first + r, 0, 0); };
  const Path big = [=](Real t) { return Real3(gaps(t).second + 3 * r, 0, 0); };
  return {scene, "masses 1 : 10⁶ and a wall, 3141 impacts: two reflections unfolded; relative to their radius",
          off_paths(scene, {{0, small}, {1, big}}, r)};
}

/// A chaotic scene: the error of one impact grows by a factor of ten and more until the next. Truth: the same impacts
/// computed with 60 digits (tests/app/motion/pool_break.py).
MotionScene pool_break() {
  std::vector<Body> bodies{ball(0.5, {-3, 0.0625, 0}, {{8, 0, 0}, {0, 0, 0}})};
  for (int row = 0; row < 5; ++row) {
    for (int k = 0; k <= row; ++k) bodies.push_back(ball(0.5, {0.890625 * row, 1.03125 * (k - row / 2.0), 0}));
  }
  const Scene scene = scene_of("pool_break", bodies, {.g = 0, .restitution = 1, .step = 0.125, .samples = 16});
  std::map<int, Path> paths;
  for (int k = 0; k < 16; ++k) {
    paths[k] = [k](Real t) {
      const auto& [x, y] =
          pool_break_truth.at(static_cast<std::size_t>(t / 0.125L) - 1).at(static_cast<std::size_t>(k));
      return Real3(x, y, 0);
    };
  }
  return {scene, "a break of 15 balls, against the same with 60 digits; relative to their radius",
          off_paths(scene, paths, 0.5)};
}

}  // namespace

std::vector<MotionScene> billiard_scenes() { return {newtons_cradle(), pi_billiard(), pool_break()}; }

}  // namespace touchstone::app
