// Both bounds of the depth, for boxes whose depth is read off.
#include "fast/penetration/depth_bracket.h"

#include "fast/lin_canny/bracket.h"
#include "tests/catch.h"

namespace touchstone::fast::penetration {
namespace {

using lin_canny::Hull;
using lin_canny::PosedHull;

struct Boxes {
  Boxes(const Vec3& half_A, const Vec3& half_B, const Vec3& p_AB) : hull_A(Box{half_A}), hull_B(Box{half_B}) {
    A.hull = &hull_A;
    B.hull = &hull_B;
    B.t = p_AB;
  }
  Hull hull_A, hull_B;
  PosedHull A, B;
};

TEST_CASE("boxes that overlap by a quarter along x: the bounds are a few rounding errors apart") {
  const Boxes boxes({1, 1, 1}, {2, 2, 2}, {2.75, 0, 0});
  DepthMemory memory;
  for (int time = 0; time < 2; ++time) {  // then from the polytope that is kept
    const DepthBracket found = depth_bracket(boxes.A, boxes.B, memory);
    CHECK(found.lo <= 0.25);
    CHECK(found.hi >= 0.25);
    CHECK(found.hi - found.lo <= 9 * lin_canny::rounding(boxes.A, boxes.B));
    CHECK((found.n + Vec3(1, 0, 0)).norm() <= 0x1p-40);  // A moves away from B
    CHECK(height_along(boxes.A, boxes.B, found.n) == found.height);
    CHECK_FALSE(memory.polytope.empty());
  }
}

TEST_CASE("boxes that are apart, that touch, and that overlap by less than rounding: nothing is proved") {
  for (const double x : {4.0, 3.0, 3 - 0x1p-50}) {
    const Boxes boxes({1, 1, 1}, {2, 2, 2}, {x, 0, 0});
    DepthMemory memory;
    const DepthBracket found = depth_bracket(boxes.A, boxes.B, memory);
    CHECK(found.lo == 0);
    CHECK(found.hi >= 3 - x);
  }
}

TEST_CASE("a plate as thin as rounding has no lower bound") {
  const Boxes boxes({1, 1, 0x1p-53}, {1, 0x1p-53, 1}, {0, 0, 0});
  DepthMemory memory;
  CHECK(depth_bracket(boxes.A, boxes.B, memory).hi >= 1);
}

}  // namespace
}  // namespace touchstone::fast::penetration
