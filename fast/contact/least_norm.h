// Linear systems that have many solutions or none: redundant contacts.
#pragma once

#include <Eigen/Core>

namespace touchstone::fast::contact {

/// The x of least norm among those with the least |A x − b|, by a complete orthogonal decomposition (Golub & Van Loan
/// 2013, Matrix Computations, 5.4.2). A: m × n, b: m, x: n. Pivots below Eigen's default threshold (machine precision ·
/// min(m, n) of the greatest) count as 0.
Eigen::VectorXd least_norm_solution(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

}  // namespace touchstone::fast::contact
