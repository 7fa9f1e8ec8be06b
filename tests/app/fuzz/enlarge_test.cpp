// The search for a larger error finds one, stays in the domain, and changes numbers only.
#include "app/fuzz/enlarge.h"

#include <cmath>
#include <optional>
#include <type_traits>
#include <variant>

#include "app/fuzz/scene_numbers.h"
#include "oracle/passing_on.h"
#include "oracle/subjects/touchstone/reference.h"
#include "tests/catch.h"

namespace touchstone::app {
namespace {

using properties::Property;

/// Says a distance that is too great by a thousandth of A's height over the ground.
class TooFarAbove final : public oracle::PassingOn<TooFarAbove> {
 public:
  TooFarAbove(oracle::Subject& truthful, const oracle::Domain& domain) : PassingOn(truthful), card_(truthful.card()) {
    card_.precision = oracle::Precision::binary64;
    card_.domain = domain;
  }

  const oracle::Card& card() const override { return card_; }

 private:
  friend PassingOn;

  template <class T>
  Answer<T> pass(Answer<T> (Subject::*query)(const Scene&), const Scene& scene) {
    Answer<T> answer = (subject_.*query)(scene);
    if constexpr (std::is_same_v<T, Distance>) {
      auto& said = std::get<Distance>(answer);
      if (said.verdict == Verdict::separated) *said.distance += std::abs(scene.bodies[0].X_WB.p_WB.z()) * 1e-3;
    }
    return answer;
  }

  oracle::Card card_;
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
  const auto reference = oracle::subjects::make_reference();
  TooFarAbove subject(*reference, domain);
  const Property& property = properties::find("distance.value");
  const Example example{"", 0, scene, property.check(scene, subject), {}};
  REQUIRE(example.finding.outcome == oracle::Outcome::fails);
  return enlarged(example, property, subject, 600);
}

TEST_CASE("An error that grows with a number is made larger, in the same way each time") {
  const Scene scene = two_boxes();
  const auto reference = oracle::subjects::make_reference();
  TooFarAbove subject(*reference, {});
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
