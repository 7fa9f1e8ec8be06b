#include "fast/impulse/series.h"

#include <cmath>
#include <limits>

#include "tests/catch.h"

namespace touchstone::fast::impulse {
namespace {

TEST_CASE("series: a root that is 2^-29 of the length of the series is as precise as any") {
  Series x;  // t + 100 t²
  x.order = 2;
  x.x[1] = 1;
  x.x[2] = 100;
  double miss = 1;
  for (const double length : {0x1p-3, 0x1p-16, 0x1p-30}) {
    const auto root = first_reach(x, 0x1p-32, length, miss);
    REQUIRE(root);
    const double exact = 0x1p-32 * (1 - 100 * 0x1p-32);  // but for 2·10⁴ · 2^-64 of it
    CHECK(std::abs(*root - exact) < 0x1p-48 * exact);
  }
}

// Such is the work that is restored while u_n rises from 0, but for rounding, and falls again: t² − t³.
TEST_CASE("series: what begins with a slope of 0 is reached on the way to a maximum") {
  for (const double rounding : {0.0, 0x1p-60, -0x1p-60}) {
    Series x;
    x.order = 3;
    x.x[1] = rounding;
    x.x[2] = 1;
    x.x[3] = -1;
    double miss = 1;
    const auto root = first_reach(x, 0.125, 1.25, miss);
    REQUIRE(root);
    CHECK(*root == Approx(0.5));  // 1/4 − 1/8
    CHECK_FALSE(first_reach(x, 0.25, 1.25, miss));
  }
}

TEST_CASE("series: a coefficient that is 0 limits no length") {
  CHECK(length_for(0, 12) == std::numeric_limits<double>::max());
  const double term = std::pow(length_for(1, 8), 8);
  CHECK(term <= 0x1p-56);
  CHECK(term > 0x1p-60);
}

}  // namespace
}  // namespace touchstone::fast::impulse
