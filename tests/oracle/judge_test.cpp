// How an error becomes a finding.
#include "oracle/judge/judge.h"

#include <limits>

#include "tests/catch.h"

namespace touchstone::oracle {
namespace {

Outcome outcome(double error, double bound) {
  const auto text = [] { return std::string(); };
  return judge::at_most(error, {.bound = bound}, Defect::too_far, text, text).outcome;
}

TEST_CASE("at_most: an error up to the bound holds, one beyond it or none at all fails") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(outcome(1, 1) == Outcome::holds);
  CHECK(outcome(1 + 0x1p-52, 1) == Outcome::fails);
  CHECK(outcome(nan, 1) == Outcome::fails);
  CHECK(outcome(1, nan) == Outcome::fails);
}

}  // namespace
}  // namespace touchstone::oracle
