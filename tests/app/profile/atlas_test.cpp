// Each scene is in the class of its size, and a declared limit divides the classes that it divides.
#include "app/profile/atlas.h"

#include <algorithm>

#include "oracle/truth/truth.h"
#include "tests/catch.h"

namespace touchstone::app {
namespace {

const AtlasAxis& axis(const std::string& name) { return *std::ranges::find(atlas_axes(), name, &AtlasAxis::name); }

/// Bounds of the scene's class on the axis.
Interval place(const Scene& scene, const std::string& query, const std::string& name) {
  for (const auto& [index, k] : places_of(scene, query)) {
    const AtlasAxis& found = atlas_axes()[static_cast<std::size_t>(index)];
    if (found.name == name) return class_bounds(found, k);
  }
  return {-1, -1};
}

bool within(const Interval& bounds, double value) { return bounds.lo < value && value <= bounds.hi; }

Body ball(double radius, double x) {
  Body body;
  body.shape = Sphere{radius};
  body.X_WB.p_WB = Vec3(x, 0, 0);
  return body;
}

TEST_CASE("Two balls are in the classes of their sizes") {
  Scene scene;
  scene.bodies = {ball(0.25, 0), ball(2, 6)};
  scene.bodies[1].velocity.v_WBcm = Vec3(0, 3, 4);
  const Scene completed = oracle::truth::completed(scene);
  CHECK(within(place(completed, "distance", "length"), 4));
  CHECK(within(place(completed, "distance", "thickness"), 0.5));
  CHECK(within(place(completed, "distance", "reach"), 8));
  CHECK(within(place(completed, "distance", "gap"), 3.75 / 8));
  CHECK(place(completed, "distance", "speed").hi == -1);
  CHECK(within(place(completed, "time_of_impact", "speed"), 5));
  CHECK(within(place(completed, "time_of_impact", "mass ratio"), 512));
  CHECK(place(completed, "time_of_impact", "spin").hi == 0);
}

TEST_CASE("Bodies that touch have a class of their own, as has a value on an edge") {
  Scene scene;
  scene.bodies = {ball(1, 0), ball(1, 2)};
  CHECK(place(oracle::truth::completed(scene), "distance", "gap").hi == 0);
  CHECK(place(oracle::truth::completed(scene), "distance", "aspect").hi == 1);
}

TEST_CASE("A limit lies inside one class at most") {
  oracle::Domain domain;
  domain.vertices = 6;
  domain.lengths = Interval{0.01, 10};
  const auto sides = [&](const std::string& name) {
    std::vector<DomainSide> all;
    for (int k = 0; k <= static_cast<int>(axis(name).edges.size()); ++k) all.push_back(side_of(axis(name), k, domain));
    return all;
  };
  const auto count = [](const std::vector<DomainSide>& all, DomainSide side) { return std::ranges::count(all, side); };
  const std::vector<DomainSide> vertices = sides("vertices");  // 0, 4, 8, ...: 6 divides the third class
  CHECK(vertices[1] == DomainSide::inside);
  CHECK(vertices[2] == DomainSide::across);
  CHECK(vertices[3] == DomainSide::outside);
  CHECK(count(sides("length"), DomainSide::across) == 0);  // 10 is an edge
  CHECK(count(sides("length"), DomainSide::outside) > 0);
  CHECK(sides("thickness").front() == DomainSide::outside);
  CHECK(sides("thickness").back() == DomainSide::inside);
  CHECK(count(sides("reach"), DomainSide::inside) == static_cast<long>(sides("reach").size()));
}

TEST_CASE("A scene fails if any of its answers does, and counts once") {
  oracle::Finding wrong, right, silent;
  wrong.outcome = oracle::Outcome::fails;
  wrong.error = 8;
  wrong.allowed = 2;
  wrong.unit = "m";
  silent.outcome = oracle::Outcome::abstains;
  SceneOutcome fails, holds, abstains;
  for (const auto& finding : {right, wrong, right, silent}) fails.add(finding);
  holds.add(right);
  abstains.add(silent);
  Atlas atlas;
  for (const SceneOutcome& outcome : {fails, holds, abstains}) add(atlas, {{2, 5}}, outcome);
  const AtlasCell& cell = atlas.at({2, 5});
  CHECK(cell.scenes == 2);
  CHECK(cell.failing == 1);
  CHECK(cell.broken == 0);
  CHECK(cell.excess == 4);
}

}  // namespace
}  // namespace touchstone::app
