// Each property detects a canary, each canary is detected, each clause is proved sharp, and no truthful subject is
// accused.
#include <algorithm>
#include <optional>

#include "oracle/subject.h"
#include "oracle/subjects/canaries/canaries.h"
#include "oracle/subjects/touchstone/fast.h"
#include "oracle/with_card.h"
#include "properties/clause.h"
#include "properties/property.h"
#include "tests/catch.h"
#include "tests/properties/generated_page.h"
#include "tests/properties/kills.h"
#include "tests/properties/scenes.h"

using namespace touchstone;

namespace {

void each_property_catches_a_canary() {
  for (auto [property, caught] : tests::kills()) {
    INFO(property);
    CHECK_FALSE(caught.empty());
    caught.erase("canary.throws");
    caught.erase("canary.nan");  // every property detects an answer that is not a number
    CHECK((property.ends_with(".survives") || !caught.empty()));
  }
}

void each_canary_is_caught() {
  for (const auto& canary : oracle::subjects::canaries()) {
    INFO(canary.id);
    CHECK(std::ranges::any_of(tests::kills(), [&](const auto& row) { return row.second.contains(canary.id); }));
  }
}

void each_clause_is_proved_sharp(const properties::Clause& clause) {
  CHECK_FALSE(clause.sharp_by.empty());
  const auto catches = [](const std::string& property, const std::string& canary) {
    return tests::kills().at(property).contains(canary);
  };
  for (const std::string& canary : clause.sharp_by) {
    INFO(clause.id << " " << canary);
    CHECK_NOTHROW(oracle::subjects::canary(canary));
    CHECK(std::ranges::any_of(clause.checked_by, [&](const std::string& id) { return catches(id, canary); }));
  }
  for (const std::string& property : clause.checked_by) {
    INFO(clause.id << " " << property);
    CHECK(std::ranges::any_of(clause.sharp_by, [&](const std::string& id) { return catches(property, id); }));
  }
}

}  // namespace

// A single test case, since each case runs as a program of its own, and the runs behind the table take seconds.
TEST_CASE("canaries prove every property and clause sharp, and the canaries' page is what they show") {
  each_property_catches_a_canary();
  each_canary_is_caught();
  for (const properties::Clause& clause : properties::clauses()) each_clause_is_proved_sharp(clause);
  CHECK(tests::committed_page("canaries.md", tests::kill_table()) == tests::kill_table());
}

// In singles some scenes are outside what an engine can be asked, not all.
TEST_CASE("each canary about crashes and memory is caught in singles too") {
  for (const properties::Property& property : properties::all()) {
    const bool survives = property.id.ends_with(".survives");
    if (!survives && !property.id.ends_with(".repeats")) continue;
    const auto& canary = oracle::subjects::canary(survives ? "canary.throws" : "canary.remembers");
    const auto caught = std::ranges::count_if(tests::scenes_of(property.query), [&](const Scene& scene) {
      const auto lie = canary.make(tests::truthful());  // its memory is part of its lie
      oracle::Card card = lie->card();
      card.precision = oracle::Precision::binary32;
      oracle::WithCard single(*lie, std::move(card));
      return oracle::failed(property.check(scene, single));
    });
    INFO(property.id);
    CHECK(caught > 0);
  }
}

TEST_CASE("the reference and fast keep every property, and each property asks them something") {
  for (const auto make : {tests::truthful, oracle::subjects::make_fast}) {
    const auto subject = make();
    for (const properties::Property& property : properties::all()) {
      int held = 0;
      for (const Scene& scene : tests::scenes_of(property.query)) {
        const oracle::Finding finding = property.check(scene, *subject);
        INFO(subject->card().name << ", " << property.id << " on " << scene.name << ": " << name_of(finding.outcome)
                                  << ", " << name_of(finding.defect) << ", " << finding.observed << " for "
                                  << finding.expected << ", " << finding.error << " of " << finding.allowed << ' '
                                  << finding.unit << finding.why);
        CHECK(finding.outcome != oracle::Outcome::fails);
        CHECK(finding.outcome != oracle::Outcome::breaks);
        held += finding.outcome == oracle::Outcome::holds ? 1 : 0;
      }
      INFO(property.id);
      const bool promises_nothing = property.id.ends_with(".work") && subject->card().work_limits.empty();
      // The reference reports impacts alone, no contact that lasts.
      const bool has_no_contacts = property.id == "simulation.touches" && subject->card().name == "reference";
      // No run made by hand bounces within the envelope: drawn_canaries_test.cpp asks fast about a drawn one.
      const bool has_no_bounces = property.id == "simulation.bounces_end";
      CHECK((held > 0 || promises_nothing || has_no_contacts || has_no_bounces));
    }
  }
}

namespace {

bool is_slight(const oracle::subjects::Canary& canary) {
  return canary.id.starts_with("canary.slight") || canary.id == "canary.feature_off_by_one";
}

/// Does some canary that is wrong by two to eight times what the property allows fail it? None if nothing is allowed.
std::optional<bool> catches_slight_errors(const properties::Property& property) {
  std::optional<bool> caught;
  for (const auto& canary : oracle::subjects::canaries()) {
    if (!is_slight(canary) || std::ranges::count(canary.lies_about, property.query) == 0) continue;
    for (const Scene& scene : tests::scenes_of(property.query)) {
      const auto subject = canary.make(tests::truthful());
      const oracle::Finding finding = property.check(scene, *subject);
      if (!(finding.allowed > 0)) continue;
      caught = caught.value_or(false);
      const double excess = finding.error / finding.allowed;
      if (finding.outcome == oracle::Outcome::fails && excess >= 2 && excess <= 8) return true;
    }
  }
  return caught;
}

}  // namespace

// A tolerance that becomes a thousand times wider accuses no truthful subject, and a canary that is wrong by far is
// still caught. The allowances of trajectories are those of bounces within the envelope, or of steps: they depend on
// the run, and no canary is so near to them.
TEST_CASE("canaries: each allowance, but for those of trajectories, has one that is wrong by two to eight times it") {
  for (const properties::Property& property : properties::all()) {
    if (property.query == "simulation" || property.query == "constraint") continue;
    INFO(property.id);
    CHECK(catches_slight_errors(property).value_or(true));
  }
}
