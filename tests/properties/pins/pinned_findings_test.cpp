// What the judge says of a truthful subject and of a wrong one, on the first scenes of each family.
#include <algorithm>
#include <cstdio>
#include <memory>

#include "oracle/subjects/canaries/canaries.h"
#include "oracle/subjects/touchstone/fast.h"
#include "properties/property.h"
#include "properties/scenes/domain.h"
#include "tests/catch.h"
#include "tests/properties/pins/pinned_page.h"

using namespace touchstone;

namespace {

/// Two digits: the judge's own rounding must not show.
std::string digits(double x) {
  char written[32];
  std::snprintf(written, sizeof written, "%.2g", x);
  return written;
}

std::string text(const oracle::Finding& finding) {
  return name_of(finding.outcome) + ' ' + name_of(finding.defect) + ' ' + digits(finding.allowed) + ' ' + finding.unit +
         ' ' + (finding.relative ? digits(*finding.relative) : "") + ' ' +
         (finding.of_body ? digits(*finding.of_body) : "") + ' ' + finding.why + '\n';
}

/// Simulations cost milliseconds, and some properties ask for several.
bool moves(const std::string& query) { return query == "simulation" || query == "constraint"; }

std::string found(const properties::Property& property, oracle::Subject& subject) {
  tests::Digest findings;
  int holds = 0, fails = 0;
  for (const properties::Family* family : properties::for_query(properties::families(), property.query)) {
    for (std::uint64_t i = 0; i < (moves(property.query) ? 1 : 4); ++i) {
      const oracle::Finding finding = property.check(properties::draw(*family, 1, i), subject);
      findings.add(text(finding));
      holds += finding.outcome == oracle::Outcome::holds ? 1 : 0;
      fails += oracle::failed(finding) ? 1 : 0;
    }
  }
  return std::to_string(holds) + " hold " + std::to_string(fails) + " fail " + findings.text();
}

/// fast, and canaries that lie about the query.
std::vector<std::unique_ptr<oracle::Subject>> asked_about(const std::string& query) {
  std::vector<std::unique_ptr<oracle::Subject>> subjects;
  subjects.push_back(oracle::subjects::make_fast());
  const std::size_t most = query == "constraint" ? 1 : query == "simulation" ? 2 : 4;
  for (const oracle::subjects::Canary& canary : oracle::subjects::canaries()) {
    if (subjects.size() < most && std::ranges::count(canary.lies_about, query) > 0)
      subjects.push_back(canary.make(oracle::subjects::make_fast()));
  }
  return subjects;
}

}  // namespace

// A regression pin: which verdicts are right is for the other tests to say. It sees a fault of the judge that forgives
// or accuses otherwise on some scene. To make it anew: TOUCHSTONE_UPDATE=1 ./touchstone test -R "pins:".
TEST_CASE("pins: the findings about fast and about canaries") {
  std::string now;
  for (const std::string& query : properties::tested_queries()) {
    for (const auto& subject : asked_about(query)) {
      for (const properties::Property& property : properties::all()) {
        if (property.query == query)
          now += property.id + ' ' + subject->card().name + ' ' + found(property, *subject) + '\n';
      }
    }
  }
  const std::string pinned = tests::pinned_page("findings.txt", now);
  CHECK(tests::lines_not_in(pinned, now) == std::vector<std::string>{});
  CHECK(tests::lines_not_in(now, pinned) == std::vector<std::string>{});
}
