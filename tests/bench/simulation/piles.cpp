#include "tests/bench/simulation/piles.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "app/motion/scenes/build.h"
#include "app/motion/scenes/truths.h"
#include "properties/random.h"
#include "reference/validity.h"

namespace touchstone::bench {
namespace {

using app::block;

constexpr double moment = 1.0 / 16;  // s; between two of 16 samples

Scene scene_of(const std::string& kind, int count, std::vector<Body> bodies, double restitution) {
  return reference::completed(
      app::scene_of(kind + "_" + std::to_string(count), std::move(bodies),
                    {.restitution = restitution, .friction = 0.5, .step = moment, .samples = 16}));
}

app::MotionScene stands(const std::string& kind, int count, std::vector<Body> bodies) {
  bodies.insert(bodies.begin(), app::table(256));
  const Scene scene = scene_of(kind, count, std::move(bodies), 0);
  return {scene, "stays where it is; relative to its size", app::off_rest(scene)};
}

app::MotionScene loses_energy(const std::string& kind, int count, std::vector<Body> bodies, double restitution) {
  const Scene scene = scene_of(kind, count, std::move(bodies), restitution);
  return {scene, "energy never rises; relative to it", app::gained_energy(scene)};
}

std::vector<Body> stacked(int count) {
  std::vector<Body> bodies;
  for (int i = 0; i < count; ++i) bodies.push_back(block(Vec3::Constant(0.5), {0, 0, i + 0.5}));
  return bodies;
}

app::MotionScene stack(int count) { return stands("stack", count, stacked(count)); }

/// Each row has one cube less than the one below, and lies over the gaps between its cubes.
std::vector<Body> piled(int rows) {
  std::vector<Body> bodies;
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < rows - row; ++i)
      bodies.push_back(block(Vec3::Constant(0.5), {(i + row / 2.0) * 1.0625, 0, row + 0.5}));
  }
  return bodies;
}

app::MotionScene pyramid(int rows) { return stands("pyramid", rows * (rows + 1) / 2, piled(rows)); }

/// Ten bricks a row that touch one another, each over the place where two below touch.
app::MotionScene wall(int count) {
  std::vector<Body> bodies;
  for (int k = 0; k < count; ++k) {
    const int row = k / 10;
    bodies.push_back(block({0.5, 0.25, 0.25}, {k % 10 + row % 2 / 2.0, 0, row / 2.0 + 0.25}));
  }
  return stands("wall", count, bodies);
}

/// As the named scene: the first one rotates about its lower edge.
app::MotionScene dominoes(int count) {
  std::vector<Body> bodies{app::table()};
  for (int k = 0; k < count; ++k) bodies.push_back(block({0.125, 0.5, 1}, {0.75 * k, 0, 1}));
  bodies[1].velocity = {{2, 0, 0.25}, {0, 2, 0}};
  return loses_energy("dominoes", count, bodies, 0);
}

/// A ball falls upon the last of the bodies, beside its middle.
app::MotionScene struck(const std::string& kind, std::vector<Body> bodies) {
  const Vec3 top = bodies.back().X_WB.p_WB;
  bodies.push_back(app::ball(0.5, top + Vec3(0.25, 0, 1.25), {{0, 0, -1}, Vec3::Zero()}));
  bodies.insert(bodies.begin(), app::table());
  return loses_energy(kind, static_cast<int>(bodies.size()) - 1, bodies, 0);
}

/// Balls that fall from a lattice in a room that is as wide as they need.
app::MotionScene heap(int count) {
  properties::Random random(1, "heap", 0);
  const auto little = [&] { return (2 * random.unit() - 1) / 16; };
  int side = 1;
  while (side * side * side < count) ++side;
  std::vector<Body> bodies = app::room(side);
  for (int k = 0; k < count; ++k) {
    const double x = little(), y = little(), z = little();
    bodies.push_back(
        app::ball(0.375, Vec3(k % side + 0.5 + x, k / side % side + 0.5 + y, k / (side * side) + 0.5 + z)));
  }
  return loses_energy("heap", count, bodies, 0.25);
}

/// Balls on a table that roll in all directions and meet one another.
app::MotionScene rolling(int count) {
  properties::Random random(1, "rolling", 0);
  std::vector<Body> bodies{app::table(256)};
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * random.unit(), radius = 0.375;
    const Vec3 v(std::cos(angle), std::sin(angle), 0);
    bodies.push_back(app::ball(radius, Vec3(k % 25, k / 25, radius), {v, Vec3::UnitZ().cross(v) / radius}));
  }
  return loses_energy("rolling", count, bodies, 0.5);
}

}  // namespace

const std::vector<app::MotionScene>& piles() {
  static const std::vector<app::MotionScene> all{stack(10),
                                                 stack(50),
                                                 stack(100),
                                                 stack(200),
                                                 pyramid(8),
                                                 wall(100),
                                                 wall(200),
                                                 dominoes(6),
                                                 dominoes(24),
                                                 dominoes(100),
                                                 heap(18),
                                                 heap(100),
                                                 heap(500),
                                                 rolling(500),
                                                 struck("struck_stack", stacked(20)),
                                                 struck("struck_pyramid", piled(8))};
  return all;
}

}  // namespace touchstone::bench
