// The least subset of a simplex that has the point nearest to 0: each subset of a regular tetrahedron in turn.
#include "fast/lin_canny/simplex.h"

#include <vector>

#include "tests/catch.h"

namespace touchstone::fast::lin_canny {
namespace {

const std::vector<Vec3> corners = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};

/// The first `size` corners, seen from `from`.
Simplex simplex(int size, const Vec3& from) {
  const auto corner = [&](int i) {
    return VertexDifference{i, i, Vec3::Zero(), corners[static_cast<std::size_t>(i)] - from};
  };
  Simplex held(corner(0));
  for (int i = 1; i < size; ++i) held.add(corner(i));
  return held;
}

// From a point twice as far from the tetrahedron's centre as the middle of some corners, in the same direction, this
// middle is the nearest point.
TEST_CASE("simplex: of one to four points, those remain between which the nearest point lies") {
  for (int size = 1; size <= 4; ++size) {
    for (unsigned members = 1; members < 1U << size; ++members) {
      CAPTURE(size, members);
      std::vector<int> expected;
      Vec3 middle = Vec3::Zero();
      for (int i = 0; i < size; ++i) {
        if ((members >> i & 1U) == 0) continue;
        expected.push_back(i);
        middle += corners[static_cast<std::size_t>(i)];
      }
      middle /= static_cast<double>(expected.size());
      Simplex held = simplex(size, 2 * middle);
      Vec3 toward;
      REQUIRE(reduce(held, toward));
      std::vector<int> left;
      for (int i = 0; i < held.size; ++i) left.push_back(held.points[static_cast<std::size_t>(i)].a);
      CHECK(left == expected);
      CHECK((toward.normalized() + middle.normalized()).norm() < 1e-14);
      double sum = 0;
      for (int i = 0; i < held.size; ++i) sum += held.weights[static_cast<std::size_t>(i)];
      for (int i = 0; i < held.size; ++i) {
        CHECK(held.weights[static_cast<std::size_t>(i)] / sum == Approx(1.0 / static_cast<double>(held.size)));
      }
    }
  }
}

}  // namespace
}  // namespace touchstone::fast::lin_canny
