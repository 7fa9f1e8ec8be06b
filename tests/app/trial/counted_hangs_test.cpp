// Each question that hangs is counted once, however often its answer is used.
#include "app/trial/counted_hangs.h"

#include "properties/judging/remembered_answers.h"
#include "tests/catch.h"

namespace touchstone::app {
namespace {

/// Hangs at scenes of one body, and throws at all others.
class Hanging : public oracle::Subject {
 public:
  const oracle::Card& card() const override { return card_; }
  Answer<Distance> distance(const Scene& scene) override {
    return Breaks{scene.bodies.size() == 1 ? Breaks::Kind::hung : Breaks::Kind::threw, "why"};
  }

 private:
  oracle::Card card_;
};

TEST_CASE("A question that hangs is counted, and one that fails otherwise is not") {
  Hanging subject;
  int hangs = 0;
  CountedHangs counted(subject, hangs);
  Scene scene;
  counted.distance(scene);
  CHECK(hangs == 0);
  scene.bodies.resize(1);
  counted.distance(scene);
  counted.distance(scene);
  CHECK(hangs == 2);
  CHECK(std::holds_alternative<Abstains>(counted.mass(scene)));
}

TEST_CASE("A remembered hang is not counted again") {
  Hanging subject;
  int hangs = 0;
  CountedHangs counted(subject, hangs);
  properties::RememberedAnswers remembered(counted);
  Scene scene;
  scene.bodies.resize(1);
  for (int property = 0; property < 5; ++property) CHECK(std::holds_alternative<Breaks>(remembered.distance(scene)));
  CHECK(hangs == 1);
}

}  // namespace
}  // namespace touchstone::app
