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

TEST_CASE("fast holds every property on every test vector") {
  const auto fast = oracle::subjects::make_fast();
  std::map<std::string, int> held;
  for (const properties::Property& property : properties::all()) {
    const std::string file = vectors_file(TOUCHSTONE_SOURCE "/vectors", property.query);
    for (const TestVector& vector : read_vectors(file)) {
      if (is_extreme(vector) && !holds_for_extremes(property)) continue;
      const oracle::Finding finding = property.check(vector.scene, *fast);
      INFO(property.id << " of " << vector.source.dump() << ": " << finding.observed << finding.why);
      CHECK(!oracle::failed(finding));
      if (finding.outcome == oracle::Outcome::holds) ++held[property.query];
    }
  }
  for (const std::string& query : properties::tested_queries()) CHECK(held[query] > 0);
}

}  // namespace
}  // namespace touchstone::app
