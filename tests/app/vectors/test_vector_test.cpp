// The published test vectors, asked of our own fast under every property of their query.
#include "app/vectors/test_vector.h"

#include <map>
#include <string>

#include "oracle/subject.h"
#include "oracle/subjects/touchstone/fast.h"
#include "properties/property.h"
#include "tests/catch.h"

namespace touchstone::app {
namespace {

/// On scenes at the ends of the doubles no bound on rounding holds, so only these are asked.
bool holds_for_extremes(const properties::Property& property) {
  return property.id.ends_with(".survives") || property.id.ends_with(".repeats");
}

/// Open: edges of 1 m and 512 m, parallel at the start and 2e-7 m apart, that turn past each other. The time that fast
/// encloses is right, but one end is 0.39 s off, and it differs if the bodies are exchanged.
bool is_known(const properties::Property& property, const TestVector& vector) {
  const bool is_known = property.id == "time_of_impact.tight" || property.id == "time_of_impact.symmetric" ||
                        property.id == "time_of_impact.work";
  return is_known && vector.source.value("note", "").starts_with("Edges of 1 m and 512 m");
}

TEST_CASE("fast holds every property on every test vector, but three that are known") {
  const auto fast = oracle::subjects::make_fast();
  std::map<std::string, int> held, known;
  for (const properties::Property& property : properties::all()) {
    const std::string file = vectors_file(TOUCHSTONE_SOURCE "/vectors", property.query);
    for (const TestVector& vector : read_vectors(file)) {
      if (is_extreme(vector) && !holds_for_extremes(property)) continue;
      const oracle::Finding finding = property.check(vector.scene, *fast);
      INFO(property.id << " of " << vector.source.dump() << ": " << finding.observed << finding.why);
      CHECK(oracle::failed(finding) == is_known(property, vector));
      if (is_known(property, vector)) ++known[property.id];
      if (finding.outcome == oracle::Outcome::holds) ++held[property.query];
    }
  }
  for (const std::string& query : properties::tested_queries()) CHECK(held[query] > 0);
  CHECK(known == std::map<std::string, int>{
                     {"time_of_impact.symmetric", 1}, {"time_of_impact.tight", 1}, {"time_of_impact.work", 1}});
}

}  // namespace
}  // namespace touchstone::app
