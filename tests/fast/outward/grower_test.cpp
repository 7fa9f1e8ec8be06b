// Boxes that are swept by displacements, rounded outward whatever cancels.
#include <algorithm>
#include <cmath>

#include "fast/outward/outward.h"
#include "tests/catch.h"

namespace touchstone::fast::outward {
namespace {

// The exact ends are sums of two doubles of similar size, which a long double holds.
TEST_CASE("grower: a box that is swept holds both exact ends, and is hardly wider") {
  for (const double size : {1.0, 0x1.fffffffffffffp-1, 0x1.8000000000001p-20}) {
    for (const double moved :
         {1.0, -1.0, 0x1.5555555555555p-20, -0x1.5555555555555p-20, 0x1.2492492492493p10, -0x1.2492492492493p10}) {
      CAPTURE(size, moved);
      Grower grower;
      grower.add({}, Vec3::Zero(), Vec3::Constant(size), size);
      const Aabb before = grower.box();
      grower.stretch(Vec3::Constant(std::min(moved, 0.0)), Vec3::Constant(std::max(moved, 0.0)));
      const Aabb after = grower.box();
      const long double way = static_cast<long double>(moved) * unit;
      const long double lo = before.lo.x() + std::min(way, 0.0L), hi = before.hi.x() + std::max(way, 0.0L);
      const long double most = 0x1p-49L * (std::abs(way) + before.hi.x());
      CHECK(after.lo.x() <= lo);
      CHECK(after.hi.x() >= hi);
      CHECK(lo - after.lo.x() <= most);
      CHECK(after.hi.x() - hi <= most);
      CHECK((after.lo == Vec3::Constant(after.lo.x()) && after.hi == Vec3::Constant(after.hi.x())));
    }
  }
}

}  // namespace
}  // namespace touchstone::fast::outward
