// Depths that are read off, to the last bits, and contact without depth.
#include "fast/penetration/exact_depth.h"

#include <cmath>

#include "model/box_vertices.h"
#include "tests/catch.h"

namespace touchstone::fast::penetration {
namespace {

ExactDepth of_cubes(const Vec3& p_AB, const Quaternion& q_AB = {}) {
  const std::vector<Vec3> vertices = vertices_of(Box{Vec3(1, 1, 1)});
  const Pose at_A, at_B{p_AB, q_AB};
  exact::Difference difference({std::span(&at_A, 1), vertices}, {std::span(&at_B, 1), vertices});
  return exact_depth(difference);
}

void check(const ExactDepth& found, double depth) {
  CHECK(found.depth.lo <= depth);
  CHECK(found.depth.hi >= depth);
  CHECK(found.depth.hi - found.depth.lo <= 0x1p-46 * depth + 0x1p-1070);
  CHECK(found.n.norm() == Approx(1));
}

TEST_CASE("cubes: one in the other, faces 2^-60 deep, edges, touching") {
  check(of_cubes({0, 0, 0}), 2);
  check(of_cubes({1.75, 0, 0}), 0.25);
  check(of_cubes({1.5, -1.75, 0}), 0.25);
  check(of_cubes({0, 0, 2 - 0x1p-52}), 0x1p-52);
  check(of_cubes({2, 0, 0}), 0);
  CHECK((of_cubes({1.75, 0, 0}).n + Vec3(1, 0, 0)).norm() == 0);
}

TEST_CASE("a cube turned by 45 degrees about z: its edge is √2 from its middle") {
  const double s = 0.92387953251128674, z = 0.38268343236508978;  // cos and sin of π/8, which need not be exact
  const ExactDepth found = of_cubes({2, 0, 0}, {s, 0, 0, z});
  CHECK(found.depth.lo == Approx(std::sqrt(2.0) - 1));
}

}  // namespace
}  // namespace touchstone::fast::penetration
