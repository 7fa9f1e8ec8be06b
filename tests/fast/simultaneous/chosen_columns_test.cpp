// Least squares over columns that come and go, against a factorisation from nothing.
#include "fast/simultaneous/chosen_columns.h"

#include <Eigen/QR>
#include <random>

#include "tests/catch.h"

namespace touchstone::fast::simultaneous {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST_CASE("chosen columns: the nearest point after columns were added and removed is that of the ones left") {
  std::mt19937 generator(1);
  const auto draw = [&] { return static_cast<double>(generator()) * 0x1p-31 - 1; };
  MatrixXd A(30, 20);
  VectorXd b(30);
  for (double& x : A.reshaped()) x = draw();
  for (double& x : b) x = draw();
  ChosenColumns columns(A);
  std::vector<Eigen::Index> left;
  for (int k = 0; k < 400; ++k) {
    const auto column = static_cast<Eigen::Index>(generator() % 20);
    const auto found = std::ranges::find(left, column);
    if (found == left.end()) {
      REQUIRE(columns.add(column, 0x1p-36));
      left.push_back(column);
    } else {
      columns.remove(static_cast<std::size_t>(found - left.begin()));
      left.erase(found);
    }
    REQUIRE(columns.chosen() == left);
    const MatrixXd some = A(Eigen::all, left);
    if (!left.empty()) REQUIRE((columns.nearest(b) - some.householderQr().solve(b)).norm() < 1e-12);
  }
}

TEST_CASE("chosen columns: a column is refused if its angle to the span of the others is too small, and only then") {
  MatrixXd A(3, 5);
  A << 1, 1, 3, 2, 0,  //
      0, 1, 2, 1, 0,   //
      0, 0, 0, 0x1p-20, 1;
  ChosenColumns columns(A);
  CHECK(columns.add(0, 0x1p-36));
  CHECK(columns.add(1, 0x1p-36));
  CHECK_FALSE(columns.add(2, 0x1p-36));  // A₀ + 2 A₁
  CHECK_FALSE(columns.add(3, 0x1p-19));  // A₀ + A₁, and 2⁻²⁰ beside: a sine of 2⁻²⁰/√5
  CHECK(columns.add(3, 0x1p-36));
  CHECK_FALSE(columns.add(4, 0x1p-36));  // a space of three dimensions is full
  CHECK(columns.chosen() == std::vector<Eigen::Index>{0, 1, 3});
  columns.remove(0);
  CHECK(columns.add(4, 0x1p-36));
}

}  // namespace
}  // namespace touchstone::fast::simultaneous
