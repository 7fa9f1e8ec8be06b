// The laws that hold for every query: a hang is no other answer.
#include "properties/judging/asking.h"

#include "properties/property.h"
#include "tests/catch.h"
#include "tests/properties/fixed_subject.h"

namespace touchstone::properties {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Outcome;

/// Says how many questions it was asked if `counts`, else 1; does not answer one of them.
class Slow : public oracle::Subject {
 public:
  Slow(int hangs_at, bool counts, Breaks::Kind kind) : hangs_at_(hangs_at), counts_(counts), kind_(kind) {}
  const oracle::Card& card() const override { return card_; }
  Answer<Distance> distance(const Scene&) override {
    if (++asked_ == hangs_at_) return Breaks{kind_, "no answer within 1 s"};
    Distance said;
    said.distance = counts_ ? asked_ : 1;
    return said;
  }

 private:
  int hangs_at_;
  bool counts_;
  Breaks::Kind kind_;
  int asked_ = 0;
  oracle::Card card_;
};

Finding repeated(int hangs_at, bool counts = false, Breaks::Kind kind = Breaks::Kind::hung) {
  Slow subject(hangs_at, counts, kind);
  return repeats<Distance>(&oracle::Subject::distance, Scene{}, Scene{}, subject);
}

TEST_CASE("repeats: a question that is answered once and hangs once is not judged") {
  CHECK(repeated(0).outcome == Outcome::holds);
  CHECK(repeated(1).defect == Defect::hung);
  CHECK(repeated(2).outcome == Outcome::outside);
  CHECK(repeated(3).outcome == Outcome::holds);  // the question in between
  CHECK(repeated(4).outcome == Outcome::outside);
  CHECK(repeated(2).why == "answered once, and once not within the time limit");
}

TEST_CASE("repeats: another answer, and any other break, is nondeterministic") {
  CHECK(repeated(0, true).defect == Defect::nondeterministic);
  for (const Breaks::Kind kind : {Breaks::Kind::threw, Breaks::Kind::refused, Breaks::Kind::crashed}) {
    CHECK(repeated(2, false, kind).defect == Defect::nondeterministic);
  }
}

/// Refuses every question about motion.
struct Refuses : tests::FixedSubject {
  Answer<TimeOfImpact> time_of_impact(const Scene&) override { return refusal; }
  Answer<Trajectory> simulation(const Scene&) override { return refusal; }
  Answer<Trajectory> constraint(const Scene&) override { return refusal; }
  Answer<oracle::Work> work(const std::string&, const Scene&) override { return refusal; }
  Breaks refusal{Breaks::Kind::threw, "they overlap at the start"};
};

/// Two balls 2 m apart, of which one comes towards the other.
Scene balls_in_motion() {
  Scene scene;
  scene.bodies.resize(2);
  for (Body& body : scene.bodies) body.shape = Sphere{1};
  scene.bodies[0].mass = Fixed{};
  scene.bodies[1].mass = Density{1};
  scene.bodies[1].X_WB.p_WB = {4, 0, 0};
  scene.bodies[1].velocity.v_WBcm = {-1, 0, 0};
  scene.motion.emplace().sample_times = {1};
  return scene;
}

// A question about bodies that overlap at the start is bad input, which a subject may refuse.
TEST_CASE("asking: no property about motion is asked where bodies overlap at the start") {
  Refuses subject;
  subject.introduced.work_limits = {{"time_of_impact", "step"}, {"simulation", "step"}, {"constraint", "step"}};
  const Scene valid = balls_in_motion();
  Scene overlapping = valid;
  overlapping.bodies[1].X_WB.p_WB = {1, 0, 0};
  Scene later = overlapping;  // where the later one starts, they overlap
  later.bodies[0].mass = later.bodies[1].mass = Fixed{};
  later.bodies[1].velocity = {};
  later.motion->start_times = {0.25, 0};
  int asked = 0;
  for (const Property& property : all()) {
    if (property.query != "time_of_impact" && property.query != "simulation" && property.query != "constraint")
      continue;
    INFO(property.id);
    asked += property.check(valid, subject).outcome == Outcome::breaks;
    CHECK(property.check(overlapping, subject).outcome == Outcome::outside);
    if (property.query == "time_of_impact") CHECK(property.check(later, subject).outcome == Outcome::outside);
  }
  CHECK(asked >= 30);
}

}  // namespace
}  // namespace touchstone::properties
