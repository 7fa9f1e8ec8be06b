// Each property catches a canary, each canary is caught, and nobody is accused who tells the truth.
#include <algorithm>

#include "oracle/subjects/canaries.h"
#include "properties/property.h"
#include "tests/catch.h"
#include "tests/properties/generated_page.h"
#include "tests/properties/kills.h"
#include "tests/properties/scenes.h"

using namespace touchstone;

TEST_CASE("every property catches a canary, and not only one that gives no number at all") {
  for (auto [property, caught] : tests::kills()) {
    INFO(property);
    CHECK_FALSE(caught.empty());
    caught.erase("canary.throws");
    caught.erase("canary.nan");
    CHECK((property.ends_with(".survives") || !caught.empty()));
  }
}

TEST_CASE("every canary is caught") {
  for (const auto& canary : oracle::subjects::canaries()) {
    INFO(canary.id);
    CHECK(std::ranges::any_of(tests::kills(), [&](const auto& row) { return row.second.contains(canary.id); }));
  }
}

TEST_CASE("the reference keeps every property, and each property asks it something") {
  const auto reference = tests::truthful();
  for (const properties::Property& property : properties::all()) {
    int held = 0;
    for (const Scene& scene : tests::scenes_of(property.stem)) {
      const oracle::Finding finding = property.check(scene, *reference);
      INFO(property.id << " on " << scene.name << ": " << name_of(finding.outcome) << ", " << name_of(finding.defect)
                       << ", " << finding.observed << " for " << finding.expected << ", " << finding.error << " of "
                       << finding.allowed << ' ' << finding.unit << finding.why);
      CHECK(finding.outcome != oracle::Outcome::fails);
      CHECK(finding.outcome != oracle::Outcome::breaks);
      held += finding.outcome == oracle::Outcome::holds ? 1 : 0;
    }
    INFO(property.id);
    CHECK(held > 0);
  }
}

TEST_CASE("the canaries' page is what the canaries show") {
  CHECK(tests::committed_page("canaries.md", tests::kill_table()) == tests::kill_table());
}
