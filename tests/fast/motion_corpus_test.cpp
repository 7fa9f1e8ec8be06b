// Masses, distances, impacts and motions that once gave wrong results.
#include <filesystem>
#include <utility>

#include "fast/constraint.h"
#include "fast/distance.h"
#include "fast/impulse.h"
#include "fast/mass.h"
#include "fast/simulation.h"
#include "fast/time_of_impact.h"
#include "oracle/case.h"
#include "oracle/subject.h"
#include "properties/property.h"
#include "tests/catch.h"

namespace touchstone::fast {
namespace {

class Fast : public oracle::Subject {
 public:
  Fast() { card_.name = "fast"; }
  const oracle::Card& card() const override { return card_; }
  Answer<Distance> distance(const Scene& scene) override { return fast::distance(scene); }
  Answer<Masses> mass(const Scene& scene) override { return fast::mass(scene); }
  Answer<Impulse> impulse(const Scene& scene) override { return impulse_of(scene); }
  Answer<TimeOfImpact> time_of_impact(const Scene& scene) override { return time_of_impact_of(scene); }
  Answer<Trajectory> simulation(const Scene& scene) override { return fast::simulate(scene).trajectory; }
  Answer<Trajectory> constraint(const Scene& scene) override { return constrained(scene, {}); }

 private:
  oracle::Card card_;
};

TEST_CASE("masses, distances, impacts and motions of the corpus: what once went wrong holds") {
  Fast fast;
  for (const auto& [query, at_least] :
       {std::pair("distance", 6), std::pair("impulse", 2), std::pair("mass", 4), std::pair("time_of_impact", 5),
        std::pair("simulation", 10), std::pair("constraint", 1)}) {
    int cases = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(TOUCHSTONE_SOURCE) / "properties/corpus" / query)) {
      if (entry.path().extension() != ".json") continue;
      const oracle::Case asked = oracle::read_case(entry.path().string());
      const oracle::Finding found = properties::find(asked.property).check(asked.scene, fast);
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
