// Vertices that are high along a direction, of few vertices and of many.
#include "fast/lin_canny/facing.h"

#include <cmath>
#include <limits>

#include "tests/catch.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::fast::lin_canny {
namespace {

using tests::Dice;

TEST_CASE("facing: from the vertex that is found no edge rises beyond what floats can tell") {
  Dice dice(41);
  for (const int vertices : {4, 20, 40, 300}) {
    const Hull hull(tests::round_hull(dice, vertices));
    for (int i = 0; i < 200; ++i) {
      const Vec3 unit = dice.in_cube().normalized();
      const int v = facing(hull, std::ldexp(1.0, dice.between(-900, 900)) * unit);
      CHECK(facing(hull, 0x1p-3 * unit) == facing(hull, unit));
      for (const Hull::Spokes& some : hull.spokes(v)) {
        for (const int other : {some.other[0], some.other[1], some.other[2], some.other[3]}) {
          const Vec3 along = hull.vertex(other) - hull.vertex(v);
          CHECK(along.dot(unit) <= 0x1p-19 * along.norm());  // 2 · 7 · 2^-24 |d|_1, and |d|_1 <= sqrt(3)
        }
      }
    }
  }
}

TEST_CASE("facing: what is no direction gives a vertex too") {
  Dice dice(43);
  for (const int vertices : {8, 300}) {
    const Hull hull(tests::round_hull(dice, vertices));
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    for (const Vec3& d :
         {Vec3(0, 0, 0), Vec3(nan, 0, 0), Vec3(1, nan, 0), Vec3(1, 0, nan), Vec3(inf, 1, 0), Vec3(-inf, inf, nan)}) {
      CHECK(facing(hull, d) == 0);
    }
  }
}

}  // namespace
}  // namespace touchstone::fast::lin_canny
