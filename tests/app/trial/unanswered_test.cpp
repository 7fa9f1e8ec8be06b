// What a subject never answers counts as not offered, whatever it threw; what it answers once is judged.
#include "app/trial/unanswered.h"

#include "tests/catch.h"

namespace touchstone::app {
namespace {

using oracle::Defect;
using oracle::Outcome;
using properties::Property;

const std::vector<Property> properties_of_two_queries = {
    {"a.one", "a", {}, "", {}}, {"a.two", "a", {}, "", {}}, {"b.one", "b", {}, "", {}}};

Ledger of_one_subject() {
  const std::vector<Property>& three = properties_of_two_queries;
  return {{&three[0], &three[1], &three[2]}, {{0, {}, "exec:engine", "engine"}}};
}

void count(Ledger& ledger, std::size_t property, Outcome outcome, Defect defect = Defect::none) {
  Example example;
  example.scene.bodies.assign(2, Body{"", Sphere{1}, {}, {}, {}, {}});
  example.finding.outcome = outcome;
  example.finding.defect = defect;
  example.finding.why = outcome == Outcome::abstains ? "no depth" : "hull failed";
  ledger.results.all()[property].count(example);
}

const Row& row(const Ledger& ledger, std::size_t property) { return ledger.results.all()[property]; }

TEST_CASE("A query that is never answered counts as abstained from, though some scenes threw") {
  Ledger ledger = of_one_subject();
  count(ledger, 0, Outcome::abstains);
  count(ledger, 0, Outcome::breaks, Defect::threw);
  count(ledger, 1, Outcome::breaks, Defect::threw);
  count(ledger, 1, Outcome::breaks, Defect::threw);
  count(ledger, 2, Outcome::breaks, Defect::threw);  // of another query, without an abstention
  count_as_abstentions(ledger.results);
  for (const std::size_t p : {0, 1}) {
    CHECK_FALSE(row(ledger, p).failing());
    CHECK(row(ledger, p).counts.abstains == 2);
    CHECK_FALSE(row(ledger, p).grade());
    CHECK_FALSE(row(ledger, p).examples.worst);
    CHECK_FALSE(row(ledger, p).examples.smallest);
  }
  CHECK(row(ledger, 0).why_abstains == "no depth (on 1 other scene it threw: hull failed)");
  CHECK(row(ledger, 1).why_abstains == "no depth (on 2 other scenes it threw: hull failed)");
  CHECK(row(ledger, 2).failing());
}

TEST_CASE("What an engine refuses beside what it abstains from counts as not offered, what it only refuses does not") {
  Ledger ledger = of_one_subject();
  count(ledger, 0, Outcome::abstains);
  count(ledger, 0, Outcome::breaks, Defect::refused);
  count(ledger, 2, Outcome::breaks, Defect::refused);
  count_as_abstentions(ledger.results);
  CHECK_FALSE(row(ledger, 0).failing());
  CHECK(row(ledger, 0).why_abstains == "no depth (on 1 other scene it refused: hull failed)");
  CHECK(row(ledger, 2).failing());
  CHECK(row(ledger, 2).counts.refused == 1);
}

TEST_CASE("A part that is never given counts as abstained from, a part that is given is judged") {
  Ledger ledger = of_one_subject();
  count(ledger, 0, Outcome::abstains);
  count(ledger, 0, Outcome::breaks, Defect::threw);
  count(ledger, 1, Outcome::abstains);
  count(ledger, 1, Outcome::breaks, Defect::threw);
  count(ledger, 1, Outcome::holds);
  count_as_abstentions(ledger.results);
  CHECK_FALSE(row(ledger, 0).failing());
  CHECK(row(ledger, 1).failing());
  CHECK(row(ledger, 1).counts.breaks == 1);
}

TEST_CASE("A crash, a hang or garbage stays a failure") {
  for (const Defect defect : {Defect::crashed, Defect::hung, Defect::garbage}) {
    Ledger ledger = of_one_subject();
    count(ledger, 0, Outcome::abstains);
    count(ledger, 0, Outcome::breaks, Defect::threw);
    count(ledger, 0, Outcome::breaks, defect);
    count_as_abstentions(ledger.results);
    CHECK(row(ledger, 0).counts.breaks == 2);
    CHECK(row(ledger, 0).examples.worst.has_value());
  }
}

TEST_CASE("A query without a right or wrong answer is unanswered") {
  Ledger ledger = of_one_subject();
  count(ledger, 0, Outcome::abstains);
  count(ledger, 1, Outcome::outside);
  count(ledger, 2, Outcome::fails, Defect::too_far);
  const std::vector<Unanswered> all = unanswered(ledger);
  REQUIRE(all.size() == 1);
  CHECK(all[0].query == "a");
  CHECK(all[0].subject == &ledger.subjects[0]);
}

}  // namespace
}  // namespace touchstone::app
