// Linear systems with many solutions or none.
#include "fast/contact/least_norm.h"

#include "tests/catch.h"

namespace touchstone::fast::contact {
namespace {

TEST_CASE("least norm: of many solutions the shortest") {
  const Eigen::MatrixXd A = Eigen::RowVector3d(1, 2, 2);
  const Eigen::VectorXd x = least_norm_solution(A, Eigen::VectorXd::Constant(1, 9));
  CHECK((x - Eigen::Vector3d(1, 2, 2)).norm() < 1e-14);
}

TEST_CASE("least norm: of equations that contradict each other the nearest, also if columns are equal") {
  Eigen::MatrixXd A(2, 2);
  A << 1, 1, 1, 1;
  const Eigen::VectorXd x = least_norm_solution(A, Eigen::Vector2d(1, 3));
  CHECK((x - Eigen::Vector2d(1, 1)).norm() < 1e-14);
}

}  // namespace
}  // namespace touchstone::fast::contact
