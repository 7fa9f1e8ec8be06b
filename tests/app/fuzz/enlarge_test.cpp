// The search for a larger error finds one, stays in the domain, and changes numbers only.
#include "app/fuzz/enlarge.h"

#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "app/fuzz/scene_numbers.h"
#include "oracle/subjects/touchstone/reference.h"
#include "oracle/with_card.h"
#include "tests/app/changed_distances.h"
#include "tests/catch.h"

namespace touchstone::app {
namespace {

using properties::Property;

/// Says a distance that is too great by a thousandth of A's height over the ground.
class TooFarAbove {
 public:
  explicit TooFarAbove(const oracle::Domain& domain) {
    oracle::Card card = reference_->card();
    card.precision = oracle::Precision::binary64;
    card.domain = domain;
    shown_.emplace(changed_, std::move(card));
  }

  oracle::Subject& subject() { return *shown_; }

 private:
  const std::unique_ptr<oracle::Subject> reference_ = oracle::subjects::make_reference();
  tests::ChangedDistances changed_{*reference_, [](const Scene& scene, Distance& said) {
                                     const double height = std::abs(scene.bodies[0].X_WB.p_WB.z());
                                     if (said.verdict == Verdict::separated) *said.distance += height * 1e-3;
                                   }};
  std::optional<oracle::WithCard> shown_;
};

Scene two_boxes() {
  Scene scene;
  for (const double x : {0.0, 3.0}) {
    Body body;
    body.shape = Box{Vec3(1, 1, 1)};
    body.X_WB.p_WB = {x, 0, 0.125};
    scene.bodies.push_back(body);
  }
  return scene;
}

std::optional<Example> enlarged_of(const Scene& scene, const oracle::Domain& domain) {
  TooFarAbove lying(domain);
  oracle::Subject& subject = lying.subject();
  const Property& property = properties::find("distance.value");
  const Example example{"", 0, scene, property.check(scene, subject), {}};
  REQUIRE(example.finding.outcome == oracle::Outcome::fails);
  return enlarged(example, property, subject, 600);
}

TEST_CASE("An error that grows with a number is made larger, in the same way each time") {
  const Scene scene = two_boxes();
  TooFarAbove lying({});
  oracle::Subject& subject = lying.subject();
  const Property& property = properties::find("distance.value");
  const double before = property.check(scene, subject).error;
  const std::optional<Example> found = enlarged_of(scene, {});
  REQUIRE(found);
  CHECK(found->finding.error > 2 * before);
  CHECK(property.check(found->scene, subject) == found->finding);
  CHECK(enlarged_of(scene, {})->scene == found->scene);
}

TEST_CASE("The search stays in the domain that the card declares") {
  oracle::Domain domain;
  domain.reach = 6;
  const std::optional<Example> found = enlarged_of(two_boxes(), domain);
  REQUIRE(found);
  CHECK(!oracle::beyond(domain, found->scene));
  CHECK(oracle::beyond(domain, enlarged_of(two_boxes(), {})->scene));
}

TEST_CASE("An error that no number changes stays as it is") {
  Scene scene = two_boxes();
  const auto reference = oracle::subjects::make_reference();
  const Property& property = properties::find("distance.value");
  const Example right{"", 0, scene, property.check(scene, *reference), {}};
  CHECK(!enlarged(right, property, *reference, 60));
}

TEST_CASE("The numbers of a scene are those of poses and shapes, and of velocities where something moves") {
  Scene scene = two_boxes();
  CHECK(numbers_of(scene).size() == 2 * (3 + 4 + 3));
  scene.bodies[0].shape = Sphere{2};
  scene.bodies[1].shape = Compound{{{{}, Sphere{1}}, {{}, Polytope{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}}}}};
  CHECK(numbers_of(scene).size() == 7 + 1 + 7 + (7 + 1) + (7 + 12));
  scene.contact = Contact{};
  CHECK(numbers_of(scene).size() == 7 + 1 + 7 + (7 + 1) + (7 + 12) + 2 * 6);
  for (const SceneNumber& number : numbers_of(scene)) CHECK(number.scale > 0);
  *numbers_of(scene)[0].value = 8;
  CHECK(scene.bodies[0].X_WB.p_WB.x() == 8);
}

}  // namespace
}  // namespace touchstone::app
