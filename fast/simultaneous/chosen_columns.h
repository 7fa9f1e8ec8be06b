// Some columns of a matrix, factored: least squares over them, while columns are added and removed.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace touchstone::fast::simultaneous {

/// The chosen columns as Q R, with orthonormal columns in Q and an upper triangular R. A change costs O(rows · chosen)
/// operations, where a new factorisation costs O(rows · chosen²). Keeps a reference to the matrix.
class ChosenColumns {
 public:
  explicit ChosenColumns(const Eigen::MatrixXd& A);

  const std::vector<Eigen::Index>& chosen() const { return chosen_; }

  /// Adds a column behind the others. Returns false, and changes nothing, if the sine of its angle to their span is at
  /// most `is_dependent`. Source: Gram & Schmidt's method, twice (Giraud, Langou & Rozložník 2005), which leaves Q
  /// orthonormal up to rounding for any such angle well above u.
  bool add(Eigen::Index column, double is_dependent);

  /// Removes the column chosen()[k], by Givens rotations (Golub & Van Loan 2013, §6.5.2).
  void remove(std::size_t k);

  /// x with the least |Σ x[k] A.col(chosen()[k]) − b|, with one step of refinement. Its error has the condition number
  /// of the chosen columns, times rounding; where the least distance is not small, the square of that number.
  Eigen::VectorXd nearest(const Eigen::VectorXd& b) const;

 private:
  Eigen::Index count() const { return static_cast<Eigen::Index>(chosen_.size()); }
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;

  const Eigen::MatrixXd& A_;
  std::vector<Eigen::Index> chosen_;
  Eigen::MatrixXd Q_, R_;  ///< their first count() columns are in use
};

}  // namespace touchstone::fast::simultaneous
