// Each direction has a cell, and each cell its directions.
#include "fast/lin_canny/cube_map.h"

#include <Eigen/Core>
#include <set>

#include "tests/catch.h"
#include "tests/reference/hard_pairs.h"

namespace touchstone::fast::lin_canny {
namespace {

TEST_CASE("cube map: the direction of a cell's middle is in that cell") {
  for (const int n : {1, 2, 3, 7}) {
    const CubeMap cells(n);
    CHECK(cells.cell_count() == static_cast<std::size_t>(6 * n * n));
    for (std::size_t cell = 0; cell < cells.cell_count(); ++cell) {
      const Vec3 d = cells.direction(cell);
      CHECK(d.lpNorm<Eigen::Infinity>() == 1);
      CHECK(cells.cell(d) == cell);
    }
  }
}

TEST_CASE("cube map: a direction is less than a cell away from the middle of its own") {
  tests::Dice dice(37);
  const CubeMap cells(5);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 d = dice.in_cube();
    const Vec3 scaled = d / d.lpNorm<Eigen::Infinity>();
    CHECK((cells.direction(cells.cell(scaled)) - scaled).lpNorm<Eigen::Infinity>() <= 0.2 * (1 + 0x1p-50));
  }
}

TEST_CASE("cube map: corners and edges of the cube are in a cell too") {
  const CubeMap cells(4);
  std::set<std::size_t> at_corners;
  for (int i = 0; i < 27; ++i) {
    const Vec3 d(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (d.isZero(0)) continue;
    CHECK(cells.cell(d) < cells.cell_count());
    if (d.cwiseAbs().minCoeff() == 1) at_corners.insert(cells.cell(d));
  }
  CHECK(at_corners.size() == 8);
}

}  // namespace
}  // namespace touchstone::fast::lin_canny
