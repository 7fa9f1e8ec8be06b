// Masses, distances, impacts and motions that once gave wrong results.
#include <filesystem>
#include <utility>

#include "fast/simulation.h"
#include "oracle/case.h"
#include "oracle/subject.h"
#include "oracle/subjects/touchstone/fast.h"
#include "properties/property.h"
#include "tests/catch.h"

namespace touchstone::fast {
namespace {

TEST_CASE("masses, distances, impacts and motions of the corpus: what once went wrong holds") {
  const auto fast = oracle::subjects::make_fast();  // it counts its work, which some cases are about
  for (const auto& [query, at_least] :
       {std::pair("distance", 6), std::pair("impulse", 2), std::pair("mass", 4), std::pair("time_of_impact", 5),
        std::pair("simulation", 10), std::pair("constraint", 1)}) {
    int cases = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(std::filesystem::path(TOUCHSTONE_SOURCE) /
                                                                           "properties/corpus" / query)) {
      if (entry.path().extension() != ".json") continue;
      const oracle::Case asked = oracle::read_case(entry.path().string());
      const oracle::Finding found = properties::find(asked.property).check(asked.scene, *fast);
      INFO(entry.path().string() << ": " << found.observed << " for " << found.expected);
      CHECK(found.outcome == oracle::Outcome::holds);
      ++cases;
    }
    CHECK(cases >= at_least);
  }
}

TEST_CASE("bodies whose gap is less than rounding stay together when they join, and the motion goes on") {
  const std::filesystem::path corpus = std::filesystem::path(TOUCHSTONE_SOURCE) / "properties/corpus/simulation";
  const Simulated done = simulate(oracle::read_case((corpus / "gap_below_rounding.json").string()).scene);
  CHECK_FALSE(done.stopped.has_value());
  CHECK(done.statistics.contact_steps > 0);
}

}  // namespace
}  // namespace touchstone::fast
