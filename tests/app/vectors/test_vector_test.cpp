// The published test vectors, asked of our own fast under every property of their query.
#include "app/vectors/test_vector.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "oracle/subject.h"
#include "oracle/subjects/touchstone/fast.h"
#include "oracle/subjects/touchstone/fast_pairs.h"
#include "properties/property.h"
#include "tests/catch.h"

namespace touchstone::app {
namespace {

/// On scenes at the ends of the doubles no bound on rounding holds, so only these are asked.
bool holds_for_extremes(const properties::Property& property) {
  return property.id.ends_with(".survives") || property.id.ends_with(".repeats");
}

/// How many findings of each query hold; none may be a failure.
std::map<std::string, int> held_by(oracle::Subject& subject, const std::vector<std::string>& queries) {
  std::map<std::string, int> held;
  for (const properties::Property& property : properties::all()) {
    if (std::ranges::count(queries, property.query) == 0) continue;
    const std::string file = vectors_file(TOUCHSTONE_SOURCE "/vectors", property.query);
    for (const TestVector& vector : read_vectors(file)) {
      if (is_extreme(vector) && !holds_for_extremes(property)) continue;
      const oracle::Finding finding = property.check(vector.scene, subject);
      INFO(property.id << " of " << vector.source.dump() << ": " << finding.observed << finding.why);
      CHECK(!oracle::failed(finding));
      if (finding.outcome == oracle::Outcome::holds) ++held[property.query];
    }
  }
  return held;
}

TEST_CASE("fast holds every property on every test vector") {
  const auto fast = oracle::subjects::make_fast();
  std::map<std::string, int> held = held_by(*fast, properties::tested_queries());
  for (const std::string& query : properties::tested_queries()) CHECK(held[query] > 0);
}

TEST_CASE("pairs that are followed hold every property of distance and penetration on every test vector") {
  for (const char* name : {"warm", "cold"}) {
    const auto pairs = oracle::subjects::make_fast_pairs(name);
    std::map<std::string, int> held = held_by(*pairs, {"distance", "penetration"});
    CHECK(held["distance"] > 0);
    CHECK(held["penetration"] > 0);
  }
}

}  // namespace
}  // namespace touchstone::app
