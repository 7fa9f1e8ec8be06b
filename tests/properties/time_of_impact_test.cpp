// The outcomes of the time_of_impact properties, for answers computed by hand.
#include <cmath>

#include "oracle/tolerance/motion.h"
#include "properties/property.h"
#include "tests/catch.h"
#include "tests/properties/fixed_subject.h"
#include "tests/properties/scenes.h"

using namespace touchstone;
using oracle::Defect;
using oracle::Outcome;
using Status = TimeOfImpact::Status;

namespace {

// 7 m high, thrown upward at 2 m/s, g = 8 m/s².
const double falls = (2 + std::sqrt(116.0)) / 8;

TimeOfImpact hit(double time) { return {Status::hit, time, {}, {}}; }
TimeOfImpact within(double lo, double hi) { return {Status::hit, (lo + hi) / 2, Interval{lo, hi}, {}}; }
TimeOfImpact undecided(double lo, double hi, double gap) { return {Status::undecided, {}, Interval{lo, hi}, gap}; }
const TimeOfImpact miss{Status::miss, {}, {}, {}};

oracle::Finding judged(const std::string& property, const std::string& scene, const TimeOfImpact& said) {
  tests::FixedSubject subject;
  subject.said_time_of_impact = said;
  return properties::find("time_of_impact." + property).check(tests::scene(scene), subject);
}

const std::string ball = "a ball thrown at a table", parting = "cubes that touch and part",
                  passing = "a ball that passes", plate = "a shot through a thin plate";

}  // namespace

TEST_CASE("time_of_impact: a time is right to rounding, and no more") {
  CHECK(judged("agrees", ball, hit(falls)).outcome == Outcome::holds);
  CHECK(judged("agrees", ball, hit(falls + 1e-9)).defect == Defect::too_late);
  CHECK(judged("agrees", ball, hit(falls - 1e-9)).defect == Defect::too_early);
  CHECK(judged("agrees", ball, miss).defect == Defect::missed);
  CHECK(judged("agrees", ball, hit(5)).defect == Defect::inconsistent);
  CHECK(judged("agrees", ball, {Status::hit, {}, {}, {}}).outcome == Outcome::abstains);
  CHECK(judged("agrees", passing, miss).outcome == Outcome::holds);
  CHECK(judged("agrees", passing, hit(2)).defect == Defect::phantom);
}

// The ball meets the table at √116 m/s, so 10⁻⁵ s are 1.077·10⁻⁴ m.
TEST_CASE("time_of_impact: what a card declares of its contacts is granted, and no more") {
  const Scene scene = tests::scene(ball);
  const auto outcome = [&](double time, const oracle::ContactTolerance& declared) {
    tests::FixedSubject subject;
    subject.introduced.contact_tolerance = declared;
    subject.said_time_of_impact = hit(time);
    return properties::find("time_of_impact.agrees").check(scene, subject).outcome;
  };
  const double thickness = oracle::sizes_of(scene).lengths.lo;
  const double way = oracle::tolerance::longest_way(scene, scene.motion->sample_times.back());
  for (const double off : {1e-5, -1e-5}) {
    CAPTURE(off);
    CHECK(outcome(falls + off, {.absolute = 1.08e-4}) == Outcome::holds);
    CHECK(outcome(falls + off, {.absolute = 1.07e-4}) == Outcome::fails);
    CHECK(outcome(falls + off, {.size = 1.08e-4 / thickness}) == Outcome::holds);
    CHECK(outcome(falls + off, {.size = 1.07e-4 / thickness}) == Outcome::fails);
    CHECK(outcome(falls + off, {.way = 1.08e-4 / way}) == Outcome::holds);
    CHECK(outcome(falls + off, {.way = 1.07e-4 / way}) == Outcome::fails);
  }
}

TEST_CASE("time_of_impact: touching bodies that part may count as met where a tolerance is declared") {
  tests::FixedSubject subject;
  subject.introduced.contact_tolerance.absolute = 1e-6;
  subject.said_time_of_impact = hit(0);
  const auto start = [&](const std::string& scene) {
    return properties::find("time_of_impact.start").check(tests::scene(scene), subject).outcome;
  };
  CHECK(start(parting) == Outcome::outside);
  CHECK(start("cubes that touch and approach") == Outcome::holds);
  subject.said_time_of_impact = miss;
  CHECK(start("cubes that touch and approach") == Outcome::fails);
}

TEST_CASE("time_of_impact: what is through is not forgotten") {
  CHECK(judged("agrees", plate, miss).defect == Defect::missed);
  CHECK(judged("agrees", plate, hit(0.5)).outcome == Outcome::fails);
}

TEST_CASE("time_of_impact: to leave open what is clear is wrong") {
  CHECK(judged("agrees", ball, undecided(1, 2, 0.1)).outcome == Outcome::abstains);
  CHECK(judged("decided", ball, undecided(1, 2, 0.1)).defect == Defect::inconsistent);
  CHECK(judged("decided", passing, undecided(1, 2, 0.1)).defect == Defect::inconsistent);
  CHECK(judged("decided", ball, miss).outcome == Outcome::holds);
}

TEST_CASE("time_of_impact: an enclosure is never late, holds, and is narrow") {
  CHECK(judged("enclosure", ball, within(falls - 1e-15, falls + 1e-15)).outcome == Outcome::holds);
  CHECK(judged("enclosure", ball, within(1, 2)).outcome == Outcome::holds);
  CHECK(judged("enclosure", ball, within(falls + 1e-12, 2)).defect == Defect::too_late);
  CHECK(judged("enclosure", ball, within(1, falls - 1e-12)).defect == Defect::broken_enclosure);
  CHECK(judged("enclosure", ball, {Status::miss, {}, Interval{1, 1}, {}}).defect == Defect::missed);
  CHECK(judged("enclosure", ball, undecided(1, 2, 1)).outcome == Outcome::holds);
  CHECK(judged("enclosure", passing, undecided(1, 2, 0.125)).defect == Defect::broken_enclosure);
  CHECK(judged("enclosure", ball, hit(falls)).outcome == Outcome::abstains);
  CHECK(judged("tight", ball, within(falls - 1e-15, falls + 1e-15)).outcome == Outcome::holds);
  CHECK(judged("tight", ball, within(falls - 1e-9, falls)).defect == Defect::loose_enclosure);
}

TEST_CASE("time_of_impact: touching and separating is no hit, touching and approaching is") {
  CHECK(judged("start", parting, miss).outcome == Outcome::holds);
  CHECK(judged("start", parting, hit(0)).defect == Defect::phantom);
  CHECK(judged("start", "cubes that touch and approach", hit(0)).outcome == Outcome::holds);
  CHECK(judged("start", "cubes that touch and approach", miss).defect == Defect::missed);
  CHECK(judged("start", "a ball thrown off a table, and back", hit(1)).outcome == Outcome::holds);
  CHECK(judged("start", ball, hit(falls)).outcome == Outcome::outside);
}

// 2^20 m from the origin a ball rises by 9e-10 m, which is less than rounding, for 2^-15 s. That the two are apart when
// the ball has gone through the table says nothing about that.
TEST_CASE("time_of_impact: where bodies part by less than rounding and touch again, the start is not judged") {
  Scene scene;
  scene.gravity = {0, 0, -8};
  scene.bodies.resize(2);
  scene.bodies[0].shape = Sphere{1};
  scene.bodies[0].X_WB.p_WB = {0x1p20, 0, 1};
  scene.bodies[0].velocity.v_WBcm = {0, 0, 0x1p-13};
  scene.bodies[1].shape = Box{{8, 8, 1}};
  scene.bodies[1].X_WB.p_WB = {0x1p20, 0, -1};
  scene.bodies[1].mass = Fixed{};
  scene.motion.emplace();
  scene.motion->sample_times = {4};
  tests::FixedSubject subject;
  for (const double time : {0.0, 0x1p-15}) {
    subject.said_time_of_impact = hit(time);
    CHECK(properties::find("time_of_impact.start").check(scene, subject).outcome == Outcome::outside);
    CHECK(properties::find("time_of_impact.agrees").check(scene, subject).outcome == Outcome::holds);
  }
}

/// Says miss, but hit of a scene in which time runs backwards: the first body flies to the left there.
struct OneWay : tests::FixedSubject {
  Answer<TimeOfImpact> time_of_impact(const Scene& scene) override {
    return scene.bodies[0].velocity.v_WBcm.x() < 0 ? hit(0.5) : miss;
  }
};

TEST_CASE("time_of_impact.reversible: a clear miss is one in both directions of time, also under gravity") {
  Scene scene;
  scene.bodies.resize(2);
  for (Body& body : scene.bodies) body.shape = Sphere{1};
  scene.bodies[0].velocity.v_WBcm = {1, 0, 8};
  scene.bodies[1].X_WB.p_WB = {4, 8, 0};
  scene.bodies[1].mass = Fixed{};
  scene.motion = Motion{.sample_times = {2}};
  const properties::Property& reversible = properties::find("time_of_impact.reversible");
  for (const double g : {0.0, 8.0}) {
    scene.gravity = {0, 0, -g};
    tests::FixedSubject right;
    right.said_time_of_impact = miss;
    OneWay wrong;
    CHECK(reversible.check(scene, right).outcome == Outcome::holds);
    CHECK(reversible.check(scene, wrong).outcome == Outcome::fails);
  }
}

TEST_CASE("time_of_impact.survives: bodies that overlap at the start may be refused, but not crash the subject") {
  Scene scene = tests::scene(ball);
  scene.bodies[0].X_WB.p_WB.z() = 0.5;
  const auto outcome = [&](Breaks::Kind kind) {
    tests::FixedSubject subject;
    subject.said_time_of_impact = Breaks{kind, "why"};
    return properties::find("time_of_impact.survives").check(scene, subject).outcome;
  };
  CHECK(outcome(Breaks::Kind::threw) == Outcome::outside);
  for (const Breaks::Kind kind : {Breaks::Kind::crashed, Breaks::Kind::hung, Breaks::Kind::garbage})
    CHECK(outcome(kind) == Outcome::breaks);
}

TEST_CASE("time_of_impact: a scene without a flight, or with overlap at the start, is outside") {
  Scene scene = tests::scene(ball);
  tests::FixedSubject subject;
  subject.said_time_of_impact = hit(0);
  scene.bodies[0].X_WB.p_WB.z() = 0.5;
  CHECK(properties::find("time_of_impact.agrees").check(scene, subject).outcome == Outcome::outside);
  scene.motion.reset();
  CHECK(properties::find("time_of_impact.agrees").check(scene, subject).outcome == Outcome::outside);
}
