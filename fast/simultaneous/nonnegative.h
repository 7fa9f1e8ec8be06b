// Least squares with unknowns that must not be negative.
#pragma once

#include <Eigen/Core>

namespace touchstone::fast::simultaneous {

/// Minimises |A x − b| over x ≥ 0, by Lawson & Hanson's active-set method (1974). A x is unique; x is not where columns
/// depend on each other, and then it has no more positive entries than A has independent columns. Columns that are
/// nearly dependent, at a sine below 2⁻³⁶, count as dependent.
///
/// `start`: x ≥ 0 from which to begin, or none. A x does not depend on it; the nearer it is, the less is done.
Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                                          const Eigen::VectorXd& start = {});

}  // namespace touchstone::fast::simultaneous
