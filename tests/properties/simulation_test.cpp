// The outcomes of the simulation properties, for a trajectory computed by hand.
#include <cmath>
#include <numbers>
#include <optional>

#include "properties/property.h"
#include "tests/catch.h"
#include "tests/properties/fixed_subject.h"
#include "tests/properties/scenes.h"

using namespace touchstone;
using oracle::Defect;
using oracle::Outcome;

namespace {

const Scene& wall() { return tests::scene("a ball against a wall"); }

State ball_at(const Vec3& p, const Vec3& v) { return {{p, {}}, {v, {0, 0, 0}}}; }

// Radius 1, 7 m from the wall at 8 m/s, elastic: it reverses after 7/8 s.
Trajectory turned_back() {
  const State still{wall().bodies[1].X_WB, {}};
  Event impact;
  impact.time = 0.875;
  impact.a = 0;
  impact.b = 1;
  impact.p_WC = {1.375, 0, 0};
  impact.nhat_BA_W = {0, 0, 1};
  impact.P_A_W = {0, 0, 16 * 4 * std::numbers::pi / 3};
  impact.after_a = ball_at({1.375, 0, 1}, {1, 0, 8});
  impact.after_b = still;
  Trajectory said;
  said.states = {{ball_at({1, 0, 4}, {1, 0, -8}), still}, {ball_at({2, 0, 6}, {1, 0, 8}), still}};
  said.events.emplace(1, impact);
  return said;
}

Event& event_of(Trajectory& said) { return said.events.value().front(); }

oracle::Finding judged(const std::string& property, const Trajectory& said) {
  tests::FixedSubject subject;
  subject.said_simulation = said;
  return properties::find("simulation." + property).check(wall(), subject);
}

const auto all_of_one = {"ordered", "flights", "event_states",   "none_missed", "contacts", "impulses",
                         "solid",   "energy",  "elastic_energy", "whole",       "lockstep"};

}  // namespace

TEST_CASE("simulation: the trajectory on paper holds") {
  for (const char* property : all_of_one) {
    INFO(property);
    const oracle::Finding finding = judged(property, turned_back());
    INFO(finding.observed << " for " << finding.expected << ", " << finding.why);
    CHECK(finding.outcome == Outcome::holds);
  }
  for (const char* property : {"momentum", "angular_momentum", "alone", "rests", "bounces"}) {
    INFO(property);
    CHECK(judged(property, turned_back()).outcome == Outcome::outside);
  }
}

TEST_CASE("simulation: one subject's answers for the time of impact and the first impact are compared") {
  const auto both = [](TimeOfImpact::Status status, std::optional<double> time, const Trajectory& run) {
    tests::FixedSubject subject;
    subject.said_simulation = run;
    subject.said_time_of_impact = TimeOfImpact{status, time, {}, {}};
    return properties::find("simulation.one_meeting").check(wall(), subject);
  };
  using Status = TimeOfImpact::Status;
  Trajectory without = turned_back(), unsaid = turned_back(), late = turned_back(), ended = turned_back();
  without.events->clear();
  unsaid.events.reset();
  event_of(late).time += 1e-6;
  ended.events->clear();
  ended.states.resize(1);
  ended.complete_until = 0.75;
  CHECK(both(Status::hit, 0.875, turned_back()).outcome == Outcome::holds);
  CHECK(both(Status::hit, 0.875 + 1e-15, turned_back()).outcome == Outcome::holds);
  CHECK(both(Status::hit, 0.875, late).defect == Defect::inconsistent);
  CHECK(both(Status::hit, 0.875, without).defect == Defect::missed);
  CHECK(both(Status::hit, 0.875, ended).outcome == Outcome::abstains);
  CHECK(both(Status::hit, 0.875, unsaid).outcome == Outcome::abstains);
  CHECK(both(Status::hit, std::nullopt, turned_back()).outcome == Outcome::abstains);
  CHECK(both(Status::undecided, std::nullopt, turned_back()).outcome == Outcome::abstains);
  CHECK(both(Status::miss, std::nullopt, without).outcome == Outcome::holds);
  CHECK(both(Status::miss, std::nullopt, turned_back()).outcome == Outcome::outside);
}

TEST_CASE("simulation: without events, states are judged alone") {
  Trajectory said = turned_back();
  said.events.reset();
  for (const char* property : {"ordered", "solid", "energy", "elastic_energy"}) {
    CHECK(judged(property, said).outcome == Outcome::holds);
  }
  CHECK(judged("flights", said).outcome == Outcome::abstains);
  CHECK(judged("none_missed", said).outcome == Outcome::abstains);
}

TEST_CASE("simulation: each wrong part is found by its own property") {
  Trajectory said = turned_back();
  said.states[1][0].X_WB.p_WB.x() += 1e-12;
  CHECK(judged("flights", said).defect == Defect::wrong_motion);
  said = turned_back();
  said.states[0][0].velocity.v_WBcm.z() += 1e-12;
  CHECK(judged("flights", said).defect == Defect::wrong_motion);
  CHECK(judged("elastic_energy", said).defect == Defect::wrong_energy);
  said = turned_back();
  event_of(said).after_a.X_WB.p_WB.z() += 1e-12;
  CHECK(judged("event_states", said).defect == Defect::wrong_motion);
  said = turned_back();
  event_of(said).after_b.velocity.v_WBcm.x() = 1e-300;
  CHECK(judged("event_states", said).outcome == Outcome::holds);
  event_of(said).after_b.velocity.v_WBcm.x() = 1e-12;
  CHECK(judged("event_states", said).defect == Defect::wrong_motion);
  said = turned_back();
  event_of(said).after_a.velocity.v_WBcm.z() += 1e-9;
  CHECK(judged("impulses", said).defect == Defect::wrong_velocity);
  said = turned_back();
  event_of(said).P_A_W.z() *= 1 + 1e-9;
  CHECK(judged("impulses", said).defect == Defect::inconsistent);
  said = turned_back();
  event_of(said).p_WC.z() = 1e-6;
  CHECK(judged("contacts", said).defect == Defect::wrong_witness);
  said = turned_back();
  event_of(said).nhat_BA_W = {0.6, 0, 0.8};
  CHECK(judged("contacts", said).defect == Defect::wrong_normal);
}

TEST_CASE("simulation: impacts too early, too late, and not at all") {
  Trajectory said = turned_back();
  event_of(said).time -= 1e-6;
  event_of(said).after_a = ball_at({1.375 - 1e-6, 0, 1 + 8e-6}, {1, 0, 8});
  CHECK(judged("contacts", said).defect == Defect::phantom);
  CHECK(judged("lockstep", said).defect == Defect::too_early);
  CHECK(judged("none_missed", said).outcome == Outcome::holds);
  said = turned_back();
  event_of(said).time += 1e-9;
  CHECK(judged("none_missed", said).defect == Defect::missed);
  CHECK(judged("lockstep", said).defect == Defect::too_late);
  said.events.value().clear();
  CHECK(judged("lockstep", said).outcome == Outcome::outside);
  CHECK(judged("none_missed", said).defect == Defect::missed);
  said.states[1][0] = ball_at({2, 0, 0.5}, {1, 0, -8});
  CHECK(judged("solid", said).defect == Defect::overdeep);
}

TEST_CASE("simulation: impacts in lockstep are counted, and both ends of the envelope are inside") {
  Trajectory said = turned_back();
  CHECK(judged("lockstep", said).impacts == 1);
  event_of(said).time -= 0x1p-34;  // half the envelope, at 8 m/s
  CHECK(judged("lockstep", said).error == 0);
}

TEST_CASE("simulation: a run of the moved scene may stop before the first impact, but not lose it and stop later") {
  struct TwoAnswers : tests::FixedSubject {
    Trajectory elsewhere;  ///< the answer for every other scene
    Answer<Trajectory> simulation(const Scene& scene) override { return scene == wall() ? said_simulation : elsewhere; }
  };
  const auto translated = [](double complete_until) {
    TwoAnswers subject;
    subject.said_simulation = turned_back();
    subject.elsewhere.states = {turned_back().states.front()};
    subject.elsewhere.events.emplace();
    subject.elsewhere.complete_until = complete_until;
    return properties::find("simulation.translated").check(wall(), subject);
  };
  CHECK(translated(0.75).outcome == Outcome::abstains);
  CHECK(translated(1.25).defect == Defect::moved_with_frame);
}

TEST_CASE("simulation: of bodies that overlap at the start nothing but form, survival and repetition is asked") {
  tests::FixedSubject subject;
  subject.said_simulation = turned_back();
  Scene inside = wall();
  inside.bodies[0].X_WB.p_WB.z() = 0.5;
  for (const char* property : {"flights", "solid", "energy", "lockstep"}) {
    CHECK(properties::find(std::string("simulation.") + property).check(inside, subject).outcome == Outcome::outside);
  }
  CHECK(properties::find("simulation.ordered").check(inside, subject).outcome == Outcome::holds);
}

TEST_CASE("simulation: what has not the form of a trajectory is not judged further") {
  Trajectory said = turned_back();
  said.states.pop_back();
  CHECK(judged("ordered", said).defect == Defect::inconsistent);
  CHECK(judged("flights", said).outcome == Outcome::outside);
  said.complete_until = 1;
  CHECK(judged("ordered", said).outcome == Outcome::holds);
  CHECK(judged("whole", said).defect == Defect::inconsistent);
  said = turned_back();
  std::swap(event_of(said).a, event_of(said).b);
  CHECK(judged("ordered", said).defect == Defect::inconsistent);
  said = turned_back();
  event_of(said).time = 2;
  CHECK(judged("ordered", said).defect == Defect::inconsistent);
}

TEST_CASE("simulation: in contact, and through what one event completes, bodies do not fly") {
  Trajectory said = turned_back();
  said.states[1][0] = ball_at({2, 0, 1}, {1, 0, 0});
  event_of(said).kind = Event::Kind::contact;
  event_of(said).after_a.velocity.v_WBcm.z() = 0;
  CHECK(judged("flights", said).outcome == Outcome::holds);
  CHECK(judged("none_missed", said).outcome == Outcome::holds);
  CHECK(judged("impulses", said).outcome == Outcome::outside);
}
