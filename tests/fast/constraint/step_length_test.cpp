#include "fast/constraint/step_length.h"

#include "tests/catch.h"

namespace touchstone::fast::constraint {
namespace {

constexpr int many = 1000;

TEST_CASE("step length: steps grow up to the longest while nothing changes, and never pass what is left") {
  StepLength length(20);
  for (const int expected : {1, 4, 16, 20, 20}) {
    CHECK(length.next(many) == expected);
    length.take(expected);
  }
  CHECK(length.next(7) == 7);
}

TEST_CASE("step length: with a longest step of 1 all steps are short") {
  StepLength length(1);
  for (int i = 0; i < 3; ++i) {
    CHECK(length.next(many) == 1);
    length.take(1);
  }
}

TEST_CASE("step length: a change is bisected down to a short step") {
  for (int change = 0; change < 64; ++change) {  // in this of the next 64 short steps
    StepLength length(64);
    for (const int steps : {1, 4, 16}) length.take(steps);
    int at = 0, tries = 0;
    while (at <= change) {
      const int n = length.next(many);
      ++tries;
      if (at + n <= change || n == 1) {
        length.take(n);
        at += n;
      } else {
        length.refuse(n);
      }
    }
    CHECK(at == change + 1);  // the step of the change was short
    CHECK(tries <= 13);       // each length from 64 down refused and taken at most once
  }
}

TEST_CASE("step length: once a change is passed, steps grow from a short one again") {
  StepLength length(64);
  for (const int steps : {1, 4}) length.take(steps);
  length.refuse(16);
  for (const int expected : {8, 4, 2, 1, 1, 1, 4, 16}) {
    CHECK(length.next(many) == expected);
    length.take(expected);
  }
}

}  // namespace
}  // namespace touchstone::fast::constraint
