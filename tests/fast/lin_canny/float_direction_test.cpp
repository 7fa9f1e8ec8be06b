// What floats decide about the slopes of edges.
#include <cmath>

#include "fast/lin_canny/hull.h"
#include "tests/catch.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::fast::lin_canny {
namespace {

using tests::Dice;

TEST_CASE("slopes in floats err by less than their bound, for directions of all lengths") {
  Dice dice(31);
  double worst = 0;
  for (int i = 0; i < 200; ++i) {
    const Hull hull(tests::round_hull(dice, 20));
    const Vec3 d = std::ldexp(1.0, dice.between(-59, 58)) * dice.in_cube().normalized();
    const FloatDirection direction(d);
    for (int v = 0; v < hull.vertex_count(); ++v) {
      for (const Hull::Spokes& some : hull.spokes(v)) {
        for (std::size_t lane = 0; lane < Hull::Spokes::lanes; ++lane) {
          const Vec3 along = hull.vertex(some.other[lane]) - hull.vertex(v);
          const double slope = along.dot(d) / along.norm();
          worst = std::max(worst, std::abs(direction.slopes(some)[lane] - slope) / direction.error());
        }
      }
    }
  }
  CHECK(worst < 1);
  CHECK(worst > 0.1);  // the bound is no better hidden than a factor of ten
}

TEST_CASE("lead down: surely, with the exception, and never where floats end") {
  const Hull cube(Box{Vec3(1, 2, 3)});
  int top = 0;
  while (cube.vertex(top) != Vec3(1, 2, 3)) ++top;
  const auto lead_down = [&](const Vec3& d, int except = -1) {
    return FloatDirection(d).lead_down(cube.spokes(top), except);
  };
  const auto neighbour = [&](const Vec3& at) {
    int v = 0;
    while (cube.vertex(v) != at) ++v;
    return v;
  };
  CHECK(lead_down(Vec3(1, 1, 1)));
  CHECK(lead_down(0x1p59 * Vec3(1, 0.5, 0.25)));
  CHECK_FALSE(lead_down(Vec3(1, 1, -1)));
  CHECK(lead_down(Vec3(1, 1, -1), neighbour(Vec3(1, 2, -3))));
  CHECK_FALSE(lead_down(Vec3(1, 1, -1), neighbour(Vec3(1, -2, 3))));
  CHECK_FALSE(lead_down(Vec3(1, 1, 0)));        // level
  CHECK_FALSE(lead_down(Vec3(1, 1, 0x1p-22)));  // down, but not surely
  CHECK_FALSE(lead_down(Vec3::Zero()));
  CHECK_FALSE(lead_down(0x1p200 * Vec3(1, 1, 1)));
  CHECK_FALSE(lead_down(0x1p-200 * Vec3(1, 1, 1)));
}

}  // namespace
}  // namespace touchstone::fast::lin_canny
