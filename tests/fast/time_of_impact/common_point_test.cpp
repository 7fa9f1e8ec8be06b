// Sharp edges that cross by little, and that miss by as little.
#include "fast/time_of_impact/common_point.h"

#include "fast/lin_canny/proximity.h"
#include "tests/catch.h"

namespace touchstone::fast::time_of_impact {
namespace {

using lin_canny::CachedPose;
using lin_canny::PosedHull;
using lin_canny::Solid;

constexpr double error = 0x1p-48;

/// A wedge of length 2 along x whose sharp edge, of about 2^-7 rad, is at z = 0 and whose back at z = -1.
Polytope wedge() {
  constexpr double half = 0x1p-8;
  return {{{-1, 0, 0}, {1, 0, 0}, {-1, half, -1}, {1, half, -1}, {-1, -half, -1}, {1, -half, -1}},
          {{0, 1, 3, 2}, {0, 4, 5, 1}, {0, 2, 4}, {1, 5, 3}, {2, 3, 5, 4}}};
}

/// The wedge, and another one above it, upside down and a quarter turn about z away, that is `depth` deep in the first.
bool share(double depth) {
  const Solid solid(wedge());
  const auto posed = [&](const Pose& X) {
    return lin_canny::posed_hull(solid.parts()[0], CachedPose(X), Vec3::Zero());
  };
  return share_a_point(posed(Pose{}), posed(Pose{{0, 0, -depth}, {0, 1, 1, 0}}), error);
}

TEST_CASE("common point: edges that cross are seen at some errors of depth, however sharp they are") {
  CHECK(share(16 * error));
  CHECK(share(0.5));
}

TEST_CASE("common point: none is seen of edges that touch or miss") {
  CHECK_FALSE(share(error / 2));
  CHECK_FALSE(share(0));
  CHECK_FALSE(share(-16 * error));
  CHECK_FALSE(share(-1));
}

}  // namespace
}  // namespace touchstone::fast::time_of_impact
