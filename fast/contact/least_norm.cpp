#include "fast/contact/least_norm.h"

#include <Eigen/QR>

namespace touchstone::fast::contact {

// Here alone, since the decomposition takes seconds to compile.
Eigen::VectorXd least_norm_solution(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  return A.completeOrthogonalDecomposition().solve(b);
}

}  // namespace touchstone::fast::contact
