// Least squares with unknowns that must not be negative: small problems as computed on paper, and the conditions of the
// minimum on drawn ones.
#include "fast/simultaneous/nonnegative.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/catch.h"

namespace touchstone::fast::simultaneous {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A x with x ≥ 0 is the nearest one: slopes are at most 0, and 0 where x is positive. They are sums of products, known
/// up to roundings of the terms.
bool is_nearest(const MatrixXd& A, const VectorXd& b, const VectorXd& x) {
  const VectorXd slope = A.transpose() * (b - A * x);
  const double terms = b.norm() + A.colwise().norm() * x;
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    const double rounding = 0x1p-45 * A.col(j).norm() * terms;
    if (x[j] < 0 || slope[j] > rounding || (x[j] > 0 && slope[j] < -rounding)) return false;
  }
  return true;
}

TEST_CASE("least squares: a negative unknown becomes 0, and the others are solved again") {
  MatrixXd A(2, 2);
  A << 1, 1, 0, 1;
  CHECK((nonnegative_least_squares(A, Eigen::Vector2d(3, 1)) - Eigen::Vector2d(2, 1)).norm() < 1e-15);
  // Unbounded: (4, -1). With x₂ = 0 the nearest point of (1, 0) x₁ is 3.
  CHECK((nonnegative_least_squares(A, Eigen::Vector2d(3, -1)) - Eigen::Vector2d(3, 0)).norm() < 1e-15);
  CHECK(nonnegative_least_squares(A, Eigen::Vector2d(-1, -2)).isZero(0));
  CHECK(nonnegative_least_squares(A, Eigen::Vector2d(0, 0)).isZero(0));
}

TEST_CASE("least squares: redundant, repeated and zero columns leave the nearest point unchanged") {
  MatrixXd A(3, 6);
  A << 1, 1, 1, 1, 1, 0, 1, 1, -1, -1, 1, 0, 1, -1, 1, -1, 1, 0;
  for (const Eigen::Vector3d& b : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(1, 0.5, 0.25), Eigen::Vector3d(0, 1, 0)}) {
    const VectorXd x = nonnegative_least_squares(A, b);
    CHECK(is_nearest(A, b, x));
    CHECK((A * x - A.leftCols(4) * nonnegative_least_squares(A.leftCols(4), b)).norm() < 1e-14);
  }
}

TEST_CASE("least squares: the conditions of the minimum hold on drawn problems, from any start") {
  std::mt19937 generator(1);
  const auto draw = [&] { return static_cast<double>(generator()) * 0x1p-31 - 1; };
  for (int k = 0; k < 400; ++k) {
    MatrixXd A(2 + k % 5, 1 + k % 11);
    for (double& x : A.reshaped()) x = draw();
    if (k % 3 == 0) A.col(A.cols() - 1) = 2 * A.col(0);
    if (k % 4 == 0) A.row(0) *= 0x1p-20;  // a body that is 2^40 times as heavy
    VectorXd b(A.rows());
    for (double& x : b) x = draw();
    const VectorXd x = nonnegative_least_squares(A, b);
    CHECK(is_nearest(A, b, x));
    VectorXd start(A.cols());
    for (double& y : start) y = std::max(0.0, draw());
    const VectorXd from_start = nonnegative_least_squares(A, b, start);
    CHECK(is_nearest(A, b, from_start));
    if (k % 4 != 0) CHECK((A * (from_start - x)).norm() < 1e-12 * (b.norm() + A.colwise().norm() * x));
  }
}

}  // namespace
}  // namespace touchstone::fast::simultaneous
