// What the judge says of a truthful subject and of a wrong one, on the first scenes of each family.
#include <algorithm>
#include <cstdio>
#include <memory>

#include "oracle/subjects/canaries/canaries.h"
#include "oracle/subjects/touchstone/fast.h"
#include "oracle/subjects/touchstone/reference.h"
#include "properties/judging/remembered_answers.h"
#include "properties/property.h"
#include "properties/scenes/domain.h"
#include "tests/catch.h"
#include "tests/properties/pins/pinned_page.h"

using namespace touchstone;

namespace {

/// So few digits that the rounding of a C library does not show.
std::string digits(double x, int precision) {
  char written[32];
  std::snprintf(written, sizeof written, "%.*g", precision, x);
  return written;
}

std::string text(const oracle::Finding& finding) {
  return name_of(finding.outcome) + ' ' + name_of(finding.defect) + ' ' + digits(finding.allowed, 9) + ' ' +
         finding.unit + ' ' + (finding.relative ? digits(*finding.relative, 2) : "") + ' ' +
         (finding.of_body ? digits(*finding.of_body, 2) : "") + ' ' + finding.why + '\n';
}

/// A subject, and about how many scenes of each family it is asked: simulations cost milliseconds, and some properties
/// ask for several.
struct Asked {
  std::unique_ptr<oracle::Subject> subject;
  std::uint64_t scenes = 0;
};

/// The findings of a property about a subject.
struct Findings {
  const properties::Property* property;
  const Asked* asked;
  tests::Digest digest;
  int holds = 0;
  int fails = 0;

  void add(const Scene& scene, properties::RememberedAnswers& answers) {
    const oracle::Finding finding = property->check(scene, answers.asked_by(*property));
    digest.add(text(finding));
    holds += finding.outcome == oracle::Outcome::holds ? 1 : 0;
    fails += oracle::failed(finding) ? 1 : 0;
  }

  std::string line() const {
    return property->id + ' ' + asked->subject->card().name + ' ' + std::to_string(holds) + " hold " +
           std::to_string(fails) + " fail " + digest.text() + '\n';
  }
};

/// As `check` asks: of each scene all properties, since judge and subject keep what they know about the last one.
std::string found(const std::string& query, const std::vector<Asked>& all) {
  std::string lines;
  for (const Asked& asked : all) {
    std::vector<Findings> findings;
    for (const properties::Property& property : properties::all()) {
      if (property.query == query) findings.push_back({&property, &asked, {}});
    }
    for (const properties::Family* family : properties::for_query(properties::families(), query)) {
      for (std::uint64_t i = 0; i < asked.scenes; ++i) {
        const Scene scene = properties::draw(*family, 1, i);
        properties::RememberedAnswers answers(*asked.subject);
        for (Findings& of : findings) of.add(scene, answers);
      }
    }
    for (const Findings& of : findings) lines += of.line();
  }
  return lines;
}

/// fast, and canaries that lie about the query; or the reference, where it is the cheaper one.
std::vector<Asked> asked_about(const std::string& query) {
  const std::uint64_t scenes = query == "simulation" || query == "constraint" ? 1 : 4;
  std::vector<Asked> all;
  all.push_back({oracle::subjects::make_fast(), scenes});
  if (query == "constraint") all.push_back({oracle::subjects::make_reference(), 12});
  const std::size_t most = query == "simulation" || query == "constraint" ? 2 : 4;
  for (const oracle::subjects::Canary& canary : oracle::subjects::canaries()) {
    if (all.size() < most && std::ranges::count(canary.lies_about, query) > 0)
      all.push_back({canary.make(oracle::subjects::make_fast()), scenes});
  }
  return all;
}

}  // namespace

// A regression pin: which verdicts are right is for the other tests to say. It sees a fault of the judge that forgives
// or accuses otherwise on some scene. To make it anew: TOUCHSTONE_UPDATE=1 ./touchstone test -R "pins:".
TEST_CASE("pins: the findings about fast and about canaries") {
  std::string now;
  for (const std::string& query : properties::tested_queries()) now += found(query, asked_about(query));
  CHECK(tests::changed_lines("findings.txt", now) == std::vector<std::string>{});
}
