// A law about two answers names and carries the second scene, if the answer about that one broke the law.
#include "app/trial/last_asked.h"

#include "app/trial/smallest.h"
#include "oracle/tolerance/tolerance.h"
#include "oracle/truth/truth.h"
#include "properties/transforms/body.h"
#include "properties/transforms/motion.h"
#include "properties/transforms/name.h"
#include "properties/transforms/scene.h"
#include "tests/catch.h"

namespace touchstone::app {
namespace {

Scene two_balls() {
  Scene scene;
  scene.bodies.assign(2, Body{"", Sphere{1}, {}, {}, {}, {}});
  scene.bodies[0].shape = Sphere{0.5};
  scene.bodies[1].X_WB.p_WB = {3, 1, 0};
  return scene;
}

/// Right, but fails where the second ball is the smaller one, and throws at small scenes or wherever it is told to.
class Particular : public oracle::Subject {
 public:
  explicit Particular(bool throws) : throws_(throws) {}
  const oracle::Card& card() const override { return card_; }
  Answer<Distance> distance(const Scene& scene) override {
    if (throws_ || oracle::tolerance::scale(scene) < 1e-3) return Breaks{Breaks::Kind::threw, "too small"};
    const bool second_is_smaller =
        std::get<Sphere>(scene.bodies[1].shape).radius < std::get<Sphere>(scene.bodies[0].shape).radius;
    Distance said;
    said.distance = oracle::truth::distance(scene).distance.hi + (second_is_smaller ? 0.25 : 0);
    return said;
  }

 private:
  bool throws_;
  oracle::Card card_{"particular", "1", oracle::Precision::binary64, {"distance"}, false, 0, "", "", {}};
};

oracle::Case found(const std::string& property, bool throws = false) {
  Particular subject(throws);
  const properties::Property& law = properties::find(property);
  return smallest_case({"family", 0, two_balls(), law.check(two_balls(), subject)}, law, subject, 1, {});
}

TEST_CASE("A case of a law has the second scene, and says how it was made") {
  const oracle::Case swapped = found("distance.symmetric");
  REQUIRE(swapped.changed);
  CHECK(swapped.finding.outcome == oracle::Outcome::fails);
  CHECK(swapped.changed->how == "the bodies in reverse order");
  CHECK(swapped.changed->scene == properties::swapped(two_balls()));
  const oracle::Case scaled = found("distance.scaled");
  REQUIRE(scaled.changed);
  CHECK(scaled.finding.outcome == oracle::Outcome::breaks);
  CHECK(scaled.changed->how == "all lengths times 2^-20");
  CHECK(scaled.changed->scene == *properties::scaled(two_balls(), -20));
}

TEST_CASE("A case whose own scene is the one that broke has no second one") {
  CHECK_FALSE(found("distance.symmetric", true).changed);
  CHECK_FALSE(found("distance.survives", true).changed);
}

TEST_CASE("Each change of the world has a name") {
  const Scene scene = two_balls();
  CHECK(properties::name_of_change(scene, *properties::translated(scene)).starts_with("the world translated by ("));
  CHECK(properties::name_of_change(scene, *properties::turned(scene)) ==
        "the world turned by 120 degrees about (1, 1, 1)");
  CHECK(properties::name_of_change(scene, properties::half_turned(scene)) == "the world turned by 180 degrees about x");
  CHECK(properties::name_of_change(scene, *properties::mirrored(scene)) == "the world mirrored in the plane x = 0");
  CHECK(properties::name_of_change(scene, *properties::scaled(scene, 10)) == "all lengths times 2^10");
  CHECK(properties::name_of_change(scene, *properties::scaled(scene, 24)) == "all lengths times 2^24");
  CHECK(properties::name_of_change(scene, *properties::denser(scene, 3)) == "all densities times 2^3");
  Scene moving = scene;
  moving.motion = Motion{.sample_times = {1, 2}};
  moving.bodies[0].mass = MassProperties{2, {}, Eigen::Matrix3d::Identity()};
  CHECK(properties::name_of_change(moving, *properties::heavier(moving, 24)) == "all masses and forces times 2^24");
  CHECK(properties::name_of_change(moving, *properties::later(moving, 0.75)) == "everything later by 0.75 s");
  Scene another = scene;
  another.bodies[0].shape = Sphere{7};
  CHECK(properties::name_of_change(scene, another) == "changed as the law says");
}

}  // namespace
}  // namespace touchstone::app
