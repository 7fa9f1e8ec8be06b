// A unit cube above a fixed block.
#include "fast/constraint/contact_search.h"

#include "fast/mark.h"
#include "model/input_error.h"
#include "tests/catch.h"

namespace touchstone::fast::constraint {
namespace {

constexpr double skin = 0x1p-10, h = 0x1p-6;

Scene cube_over_block(double gap) {
  Scene scene;
  scene.gravity = Vec3(0, 0, -8);
  scene.bodies = {{"cube", Box{Vec3::Constant(0.5)}, {Vec3(0, 0, 0.5 + gap), {}}, {}, {0, 0.25}, Density{}},
                  {"block", Box{Vec3(4, 4, 1)}, {Vec3(0, 0, -1), {}}, {}, {0, 0.5}, Fixed{}}};
  scene.motion = Motion{.sample_times = {1}};
  return scene;
}

std::vector<StepperBody> bodies_of(const Scene& scene) {
  return {StepperBody(scene.bodies[0], "bodies[0]"), StepperBody(scene.bodies[1], "bodies[1]")};
}

TEST_CASE("contact search: a face has its four corners, at the moving body, with the lesser friction") {
  const Scene scene = cube_over_block(skin);
  const std::vector<StepperBody> bodies = bodies_of(scene);
  ContactSearch search(scene, bodies, skin, h);
  const StepContacts found = search.find(bodies, h);
  REQUIRE(found.pairs.size() == 1);
  CHECK(found.pairs[0].a == 0);
  CHECK(found.pairs[0].b == 1);
  CHECK(found.pairs[0].count == 4);
  REQUIRE(found.rows.size() == 4);
  for (const contact::ContactRow& row : found.rows) {
    CHECK(row.n == Vec3(0, 0, 1));
    CHECK(row.friction == 0.25);
    CHECK(row.least_u_n == 0);  // no nearer than the skin
    CHECK(row.arm_A.cwiseAbs() == Vec3(0.5, 0.5, 0.5));
    CHECK(row.P == Vec3(0, 0, 0));
  }
}

TEST_CASE("contact search: what is farther than the skin may close its gap in the step, and no more") {
  const double gap = 2 * skin;
  Scene scene = cube_over_block(gap);
  scene.bodies[0].velocity.v_WBcm = Vec3(0, 0, -1);
  const std::vector<StepperBody> bodies = bodies_of(scene);
  ContactSearch search(scene, bodies, skin, h);
  for (const contact::ContactRow& row : search.find(bodies, h).rows) CHECK(row.least_u_n == -(gap - skin) / h);
}

TEST_CASE("contact search: bodies that touch and do not move are decided by exact arithmetic once") {
  Scene scene = cube_over_block(skin);
  scene.bodies[0].shape = Sphere{0.5};
  scene.bodies[0].X_WB.p_WB = {0, 0, 0.5};
  const std::vector<StepperBody> bodies = bodies_of(scene);
  ContactSearch search(scene, bodies, skin, h);
  const MarkCounts before = mark_counts;
  for (int step = 0; step < 8; ++step) CHECK(search.find(bodies, h).rows.size() == 1);
  CHECK(marks_since(before)[static_cast<std::size_t>(Mark::exact_proximity)] == 1);
}

TEST_CASE("contact search: out of reach there is no contact, and a pair whose boxes are apart is forgotten") {
  const Scene scene = cube_over_block(0.5);
  std::vector<StepperBody> bodies = bodies_of(scene);
  ContactSearch search(scene, bodies, skin, h);
  CHECK(search.find(bodies, h).rows.empty());
  CHECK(search.tracked().size() == 1);
  search.forget_distant();
  CHECK(search.tracked().size() == 1);
  Scene risen = scene;
  risen.bodies[0].X_WB.p_WB.z() = 1000;
  bodies = bodies_of(risen);
  search.move(0, bodies[0]);
  CHECK(search.find(bodies, h).pairs.empty());
  search.forget_distant();
  CHECK(search.tracked().empty());
}

TEST_CASE("contact search: the impulses of the last step are the guess, each at the nearest point") {
  const Scene scene = cube_over_block(skin);
  const std::vector<StepperBody> bodies = bodies_of(scene);
  ContactSearch search(scene, bodies, skin, h);
  const StepContacts first = search.find(bodies, h);
  TrackedPair& tracked = search.tracked().at({0, 1});
  const Vec3 near_2 = first.points[2].p_WC + Vec3(0.125, -0.0625, 0);
  tracked.loaded = {{near_2, Vec3(0, 0, 3)}, {first.points[2].p_WC, Vec3(0, 0, 4)}};
  const StepContacts again = search.find(bodies, h);
  REQUIRE(again.rows.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    const bool is_nearest = again.points[i].p_WC == first.points[2].p_WC;
    CHECK(again.rows[i].P == (is_nearest ? Vec3(0, 0, 7) : Vec3(0, 0, 0)));
  }
}

TEST_CASE("contact search: overlap is bad input in the first step alone") {
  const Scene scene = cube_over_block(-0.25);
  const std::vector<StepperBody> bodies = bodies_of(scene);
  ContactSearch search(scene, bodies, skin, h);
  CHECK_THROWS_AS(search.find(bodies, h), InputError);

  const Scene apart = cube_over_block(0.25);
  ContactSearch later(apart, bodies_of(apart), skin, h);
  later.find(bodies_of(apart), h);
  later.move(0, bodies[0]);
  CHECK_NOTHROW(later.find(bodies, h));
}

}  // namespace
}  // namespace touchstone::fast::constraint
