// Balls on tables, each for the lie that it shows.
#include "oracle/truth/truth.h"
#include "tests/properties/scenes.h"

namespace touchstone::tests {
namespace {

constexpr double g = 9.75;

Body table(const Vec3& half, const Vec3& place, double e, double mu, const Quaternion& q = {}) {
  return {"table", Box{half}, {place, q}, {}, {e, mu}, Fixed{}};
}

Scene on_tables(const std::string& name, const Vec3& place, const Velocity& velocity, std::vector<Body> tables,
                std::vector<double> times) {
  Scene scene;
  scene.name = name;
  scene.gravity = Vec3(0, 0, -g);
  scene.bodies = {{"ball", Sphere{0.25}, {place, {}}, velocity, {1, 16}, Density{2}}};
  for (Body& body : tables) scene.bodies.push_back(std::move(body));
  scene.motion = Motion{.sample_times = std::move(times)};
  return oracle::truth::completed(scene);
}

Scene without_gravity(Scene scene) {
  scene.gravity.setZero();
  return scene;
}

/// A block at rest on a table that may move, and take it along.
Scene block_on(const std::string& name, Body carrier, const Vec3& velocity) {
  Scene scene;
  scene.name = name;
  scene.gravity = Vec3(0, 0, -g);
  carrier.velocity.v_WBcm = velocity;
  scene.bodies = {{"block", Box{{0.5, 0.5, 0.25}}, {Vec3(0, 0, 0.25), {}}, {}, {0, 16}, Density{2}}, carrier};
  scene.motion = Motion{.sample_times = {0.25, 0.5, 1}};
  return oracle::truth::completed(scene);
}

std::vector<Scene> build_tables() {
  const Body plain = table({2, 2, 1}, {0, 0, -1}, 0, 0.125);
  return {
      on_tables("a ball that slides and then rolls", {0, 0, 0.25}, {{1, 0, 0}, {0, 0, 3}}, {plain},
                {0.125, 0.1875, 0.5, 1}),
      on_tables("a ball that falls off the table", {0, 0, 0.25}, {{3.5, 0, 0}, {0, 14, 0}},
                {plain, table({50, 50, 1}, {0, 0, -4}, 0, 1)}, {0.25, 0.75, 1.5, 2}),
      on_tables("a ball that an obstacle sends back", {0, 0, 0.25}, {{1, 0, 0}, {0, 4, 0}},
                {plain, table({0.25, 1, 1}, {1, 0, 1}, 0.5, 0)}, {0.25, 0.75, 1}),
      on_tables("a ball that falls down and bounces", {0, 0, 0.75}, {{0.5, 0, 0}, {0, -24, 0}},
                {table({2, 2, 1}, {0, 0, -1}, 0.5, 0.25)}, {0.125, 0.375, 0.5}),
      on_tables("a ball in the air, with no table", {0, 0, 0.25}, {{1, 0, 4}, {0, 4, 0}}, {}, {0.125, 0.5}),
      on_tables("a ball down a slope", {0.75, 0, 1}, {{0, 0, 0}, {0, 0, 0}},
                {table({4, 4, 1}, {0, 0, 0}, 0, 2, {3, 0, 1, 0})}, {0.125, 0.25}),
      on_tables("a ball at rest", {0, 0, 0.25}, {}, {plain}, {0.5, 1}),
      on_tables("a ball that is thrown up and bounces", {0, 0, 0.75}, {{0, 0, 1}, {0, 0, 0}},
                {table({2, 2, 1}, {0, 0, -1}, 0.5, 0.25)}, {0.25, 0.5, 1}),
      on_tables("a ball on ice", {0, 0, 0.25}, {{1, 0.5, 0}, {0, 2, 1}}, {table({4, 4, 1}, {0, 0, -1}, 0, 0)},
                {0.5, 1}),
      without_gravity(on_tables("a ball that spins on its way", {0, 0, 0}, {{1, 0, 0}, {0, 2, 1}}, {}, {0.5, 1})),
      block_on("a block on a table that moves", table({4, 4, 1}, {0, 0, -1}, 0, 0.25), {1, 0, 0}),
      block_on("a block over an edge", table({2, 2, 1}, {-2.25, 0, -1}, 0, 0.25), {0, 0, 0}),
  };
}

}  // namespace

const std::vector<Scene>& tables() {
  static const std::vector<Scene> all = build_tables();
  return all;
}

}  // namespace touchstone::tests
