// Rows that break for one cause are one cause; rows with wrong answers are causes of their own.
#include "app/trial/causes.h"

#include "tests/catch.h"

namespace touchstone::app {
namespace {

using oracle::Defect;
using oracle::Outcome;
using properties::Property;

const std::vector<Property> five = {{"a.one", "a", {}, "", {}},
                                    {"a.two", "a", {}, "", {}},
                                    {"a.three", "a", {}, "", {}},
                                    {"b.one", "b", {}, "", {}},
                                    {"b.two", "b", {}, "", {}}};

TEST_CASE("One cause in many rows is one cause") {
  Ledger ledger({&five[0], &five[1], &five[2], &five[3], &five[4]},
                {{0, {}, "exec:first", "first"}, {1, {}, "exec:second", "second"}});
  const auto count = [&](std::size_t property, std::size_t subject, Outcome outcome, Defect defect,
                         const std::string& why) {
    Example example;
    example.scene.bodies.assign(2, Body{"", Sphere{1}, {}, {}, {}, {}});
    example.finding.outcome = outcome;
    example.finding.defect = defect;
    example.finding.why = why;
    ledger.results.at(five[property], ledger.subjects[subject]).count(example);
  };
  count(0, 0, Outcome::breaks, Defect::threw, "hull 17 has no volume in part 2");
  count(1, 0, Outcome::breaks, Defect::threw, "hull 3 has no volume in part 31");
  count(2, 0, Outcome::fails, Defect::too_far, "");
  count(3, 0, Outcome::breaks, Defect::threw, "hull 4 has no volume in part 0");
  count(4, 0, Outcome::breaks, Defect::crashed, "hull 4 has no volume in part 0");
  count(0, 1, Outcome::breaks, Defect::threw, "hull 17 has no volume in part 2");
  count(1, 1, Outcome::fails, Defect::too_far, "");
  count(2, 1, Outcome::fails, Defect::too_far, "");
  count(3, 1, Outcome::breaks, Defect::refused, "a radius of 1e-07 m");
  count(4, 1, Outcome::breaks, Defect::refused, "a radius of -0.25 m");
  const std::vector<Cause> all = causes(ledger);
  std::vector<std::vector<std::string>> rows;
  for (const Cause& cause : all) {
    rows.emplace_back();
    for (const Row* row : cause.rows) rows.back().push_back(row->property->id);
  }
  CHECK(
      rows ==
      std::vector<std::vector<std::string>>{
          {"a.one", "a.two", "b.one"}, {"a.three"}, {"b.two"}, {"a.one"}, {"a.two"}, {"a.three"}, {"b.one", "b.two"}});
}

}  // namespace
}  // namespace touchstone::app
