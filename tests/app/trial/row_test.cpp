// A row of the results: what is counted, what is kept, and that counting in parts is counting at once.
#include "app/trial/row.h"

#include <cmath>

#include "tests/catch.h"

namespace touchstone::app {
namespace {

using oracle::Defect;
using oracle::Finding;
using oracle::Grade;
using oracle::Outcome;

Example example(Outcome outcome, Defect defect = Defect::none, double error = 0, std::uint64_t index = 0) {
  Example made;
  made.family = "family";
  made.index = index;
  made.finding.outcome = outcome;
  made.finding.defect = defect;
  made.finding.error = error;
  made.finding.allowed = 1;
  made.finding.unit = "ulps";
  made.scene.bodies.assign(2, Body{"", Sphere{1}, {}, {}, {}, {}});
  return made;
}

TEST_CASE("A row's grade is not milder than that of the case that is shown") {
  Row row;
  row.count(example(Outcome::fails, Defect::too_far, 5000));
  CHECK(row.grade() == Grade::C);
  row.minimised.result.emplace();
  row.minimised.result->finding = example(Outcome::fails, Defect::too_far, 0x1p30).finding;
  CHECK(row.grade() == Grade::D);
  row.minimised.result->finding = example(Outcome::fails, Defect::too_far, 5).finding;
  CHECK(row.grade() == Grade::C);
}

TEST_CASE("Each outcome has its own count, and only answers have a grade") {
  Row row;
  row.count(example(Outcome::outside));
  row.count(example(Outcome::abstains));
  CHECK_FALSE(row.grade());
  CHECK(row.answered() == 0);
  row.count(example(Outcome::holds));
  CHECK(row.grade() == Grade::A);
  CHECK_FALSE(row.failing());
  row.count(example(Outcome::fails, Defect::missed, 1e300));
  row.count(example(Outcome::breaks, Defect::crashed));
  CHECK(row.failing());
  CHECK(row.counts.holds == 1);
  CHECK(row.counts.fails == 1);
  CHECK(row.counts.breaks == 1);
  CHECK(row.counts.abstains == 1);
  CHECK(row.counts.outside == 1);
  CHECK(row.answered() == 3);
  CHECK(row.defects == std::map<Defect, long>{{Defect::missed, 1}, {Defect::crashed, 1}});
  CHECK(row.grade() == Grade::F);
}

TEST_CASE("A refusal is a failure that is counted apart") {
  Row row;
  row.count(example(Outcome::holds));
  row.count(example(Outcome::breaks, Defect::threw));
  row.count(example(Outcome::breaks, Defect::refused));
  row.count(example(Outcome::breaks, Defect::refused));
  CHECK(row.counts.breaks == 1);
  CHECK(row.counts.refused == 2);
  CHECK(row.failures() == 3);
  CHECK(row.answered() == 4);
  CHECK(row.examples.worst->finding.defect == Defect::threw);
  CHECK(share_of(row) == "3 of 4 fail (75 %), 2 of them refused");
  Row both = row;
  both.merge(row);
  CHECK(both.counts.refused == 4);
  both.forget();
  CHECK(both.counts.not_asked == 8);
}

TEST_CASE("The largest error is kept, and of equal ones the first") {
  Row row;
  row.count(example(Outcome::fails, Defect::too_far, 5, 1));
  row.count(example(Outcome::fails, Defect::too_far, 9, 2));
  row.count(example(Outcome::fails, Defect::too_far, 9, 3));
  CHECK(row.examples.worst->index == 2);
  CHECK(row.largest_error.size == 9);
}

TEST_CASE("Each defect has the worst grade of its own") {
  Row row;
  row.count(example(Outcome::fails, Defect::too_far, 0x1p11));
  row.count(example(Outcome::fails, Defect::too_far, 2));
  row.count(example(Outcome::fails, Defect::too_near, 3));
  row.count(example(Outcome::holds));
  CHECK(row.worst_grades == std::map<Defect, Grade>{{Defect::too_far, Grade::C}, {Defect::too_near, Grade::B}});
}

TEST_CASE("The share of failures: small ones keep two digits, and 100 % is all") {
  const auto share = [](long holds, long fails) {
    Row row;
    row.counts.holds = holds;
    row.counts.fails = fails;
    return share_of(row);
  };
  CHECK(share(280, 1) == "1 of 281 fail (0.36 %)");
  CHECK(share(14, 243) == "243 of 257 fail (95 %)");
  CHECK(share(1, 999) == "999 of 1000 fail (99 %)");
  CHECK(share(0, 7) == "7 of 7 fail (100 %)");
}

TEST_CASE("Errors are counted by powers of two, of right answers too, in one unit") {
  Row row;
  for (const double error : {0.0, 0.5, 0.51, 1.0, 45.0}) row.count(example(Outcome::holds, Defect::none, error));
  row.count(example(Outcome::fails, Defect::too_far, HUGE_VAL));
  Example other = example(Outcome::holds, Defect::none, 3);
  other.finding.unit = "radians";
  row.count(other);
  row.count(example(Outcome::outside));
  CHECK(row.errors.unit == "ulps");
  CHECK(row.errors.exact == 1);
  CHECK(row.errors.powers == std::map<int, long>{{-1, 1}, {0, 2}, {6, 1}});
  CHECK(row.errors.infinite == 1);
  CHECK(row.errors.total() == 6);
}

TEST_CASE("Counting in two halves and merging is counting at once") {
  std::vector<Example> asked;
  for (std::uint64_t i = 0; i < 40; ++i) {
    const auto outcome = static_cast<Outcome>(i % 5);
    asked.push_back(example(outcome, outcome == Outcome::fails ? Defect::shallow : Defect::none,
                            static_cast<double>(i * i % 11), i));
  }
  Row at_once;
  for (const Example& one : asked) at_once.count(one);
  for (std::size_t cut = 0; cut <= asked.size(); ++cut) {
    Row first;
    Row second;
    for (std::size_t i = 0; i < asked.size(); ++i) (i < cut ? first : second).count(asked[i]);
    first.merge(second);
    CHECK(first.counts.holds == at_once.counts.holds);
    CHECK(first.answered() == at_once.answered());
    CHECK(first.grades == at_once.grades);
    CHECK(first.defects == at_once.defects);
    CHECK(first.worst_grades == at_once.worst_grades);
    CHECK(first.largest_error.size == at_once.largest_error.size);
    CHECK(first.examples.worst->index == at_once.examples.worst->index);
    CHECK(first.examples.smallest->index == at_once.examples.smallest->index);
  }
}

}  // namespace
}  // namespace touchstone::app
