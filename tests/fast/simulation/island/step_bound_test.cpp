// The bound of an island's steps: how it shrinks, grows, and goes.
#include "fast/simulation/island/step_bound.h"

#include "tests/catch.h"

namespace touchstone::fast::simulation {
namespace {

TEST_CASE("step bound: none at first, it shrinks, and grows by 2, 4, 16, 256, until it is shortened again") {
  StepBound bound;
  CHECK(bound.longest() == infinity);
  bound.shorten(0x1p-16);
  bound.shorten(1);  // no longer than it is
  for (const double expected : {0x1p-15, 0x1p-13, 0x1p-9, 0x1p-1}) {
    bound.lengthen();
    CHECK(bound.longest() == expected);
  }
  bound.shorten(0x1p-16);
  bound.lengthen();
  bound.limit(0x1p-20);  // growth goes on
  bound.lengthen();
  CHECK(bound.longest() == 0x1p-18);
  bound.lift();
  CHECK(bound.longest() == infinity);
}

TEST_CASE("step bound: of two islands that merge the shorter and the slower counts") {
  StepBound slow, fast;
  slow.shorten(1);
  fast.shorten(0x1p-10);
  fast.lengthen();  // 2^-9, and 4 next
  slow.absorb(fast);
  slow.lengthen();
  CHECK(slow.longest() == 0x1p-8);
}

}  // namespace
}  // namespace touchstone::fast::simulation
