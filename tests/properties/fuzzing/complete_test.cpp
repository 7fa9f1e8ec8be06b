// A mutated scene is completed as every scene is, though most of it is not checked again.
#include "properties/fuzzing/complete.h"

#include "model/input_error.h"
#include "oracle/minimise/scene_edit.h"
#include "properties/scenes/domain.h"
#include "tests/catch.h"

namespace touchstone::properties::fuzzing {
namespace {

Scene drawn(const Family& family) { return draw(family, 5, 0); }

TEST_CASE("Scenes that lost their faces get them back") {
  for (const Family* family : for_query(families(), "distance")) {
    INFO(family->id);
    const Scene before = drawn(*family);
    Scene changed = before;
    oracle::drop_faces(changed);
    CHECK(completed_after(changed, before, Scene{}) == before);
    CHECK(completed_after(changed, Scene{}, before) == before);
    CHECK(completed_after(changed, Scene{}, Scene{}) == oracle::with_faces(changed));
  }
}

TEST_CASE("What is not valid is refused") {
  Scene before;
  before.bodies.resize(1);
  before.bodies[0].shape = Polytope{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}};
  before = oracle::with_faces(before);
  CHECK_NOTHROW(completed_after(before, before, before));

  Scene other_way_round = before;
  auto& polytope = std::get<Polytope>(other_way_round.bodies[0].shape);
  std::swap(polytope.faces[0][0], polytope.faces[0][1]);
  CHECK_THROWS_AS(completed_after(other_way_round, before, before), InputError);

  Scene flat = before;
  std::get<Polytope>(flat.bodies[0].shape) = Polytope{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {}};
  CHECK_THROWS_AS(completed_after(flat, before, before), InputError);

  Scene without_pose = before;
  without_pose.bodies[0].X_WB.q_WB = {0, 0, 0, 0};
  CHECK_THROWS_AS(completed_after(without_pose, before, before), InputError);
}

}  // namespace
}  // namespace touchstone::properties::fuzzing
