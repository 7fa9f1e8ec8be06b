// Displacements along one axis: both ends of the interval, and an apex within it.
#include "fast/outward/displacement.h"

#include <cmath>

#include "tests/catch.h"

namespace touchstone::fast::outward {
namespace {

TEST_CASE("displacement: contains both ends and the apex, and is hardly wider") {
  // v t + a t²/2 by hand. Thrown up with 10 m/s under -10 m/s²: the apex is 5 m up after 1 s.
  struct Case {
    double v, a, duration, lo, hi;
  };
  for (const Case& c : {Case{10, -10, 2, 0, 5}, Case{10, -10, 0.5, 0, 3.75}, Case{10, -10, 3, -15, 5},
                        Case{-10, 10, 2, -5, 0}, Case{3, 0, 2, 0, 6}, Case{0, -2, 3, -9, 0}, Case{1, 1, 0, 0, 0}}) {
    CAPTURE(c.v, c.a, c.duration);
    const Interval moved = displacement(c.v, c.a, c.duration);
    CHECK(moved.lo <= c.lo);
    CHECK(moved.hi >= c.hi);
    const double most =
        0x1p-49 * (std::abs(c.v) * c.duration + std::abs(c.a) * c.duration * c.duration / 2) + 0x1p-1000;
    CHECK(c.lo - moved.lo <= most);
    CHECK(moved.hi - c.hi <= most);
  }
}

}  // namespace
}  // namespace touchstone::fast::outward
