// Compounds that are one box, and such that only look like it.
#include "properties/cases/whole_tables.h"

#include "tests/catch.h"

namespace touchstone::properties {
namespace {

Part box_at(double x, const Vec3& half) { return {{{x, 0, 0}, {}}, Box{half}}; }

Shape whole(const std::vector<Part>& parts, const Mass& mass = Fixed{}) {
  Scene scene;
  scene.bodies = {{"table", Compound{parts}, {{1, 2, 3}, {1, 1, 0, 0}}, {}, {}, mass}};
  return with_whole_tables(scene).bodies[0].shape;
}

TEST_CASE("whole tables: boxes that fill a box are that box") {
  CHECK(whole({box_at(-1, {1, 2, 3}), box_at(1, {1, 2, 3})}) == Shape(Box{{2, 2, 3}}));
  CHECK(whole({box_at(1.5, {0.5, 2, 3}), box_at(-0.5, {1.5, 2, 3})}) == Shape(Box{{2, 2, 3}}));
}

TEST_CASE("whole tables: others stay what they are") {
  const std::vector<std::vector<Part>> all = {
      {box_at(-1, {1, 2, 3}), box_at(1.0625, {1, 2, 3})},                    // a gap
      {box_at(-1, {1, 2, 3}), box_at(1, {1, 2, 2})},                         // a step
      {box_at(-1, {1, 2, 3}), box_at(0.5, {1.5, 2, 3})},                     // an overlap
      {box_at(0, {1, 2, 3}), box_at(2, {1, 2, 3})},                          // not in the middle
      {box_at(-1, {1, 2, 3}), {{{1, 0, 0}, {1, 0, 0, 1}}, Box{{1, 2, 3}}}},  // turned
      {box_at(-1, {1, 2, 3}), {{{1, 0, 0}, {}}, Sphere{1}}}};
  for (const std::vector<Part>& parts : all) CHECK(whole(parts) == Shape(Compound{parts}));
  const std::vector<Part> halves = {box_at(-1, {1, 2, 3}), box_at(1, {1, 2, 3})};
  CHECK(whole(halves, Density{1}) == Shape(Compound{halves}));  // it moves
}

}  // namespace
}  // namespace touchstone::properties
