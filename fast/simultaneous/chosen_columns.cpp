#include "fast/simultaneous/chosen_columns.h"

#include <algorithm>

namespace touchstone::fast::simultaneous {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

ChosenColumns::ChosenColumns(const MatrixXd& A) : A_(A) {
  const Index most = std::min(A.rows(), A.cols());
  Q_.resize(A.rows(), most);
  R_.setZero(most, most);
}

bool ChosenColumns::add(Index column, double is_dependent) {
  const Index n = count();
  if (n == Q_.cols()) return false;
  const auto Q = Q_.leftCols(n);
  VectorXd rest = A_.col(column), along = VectorXd::Zero(n);
  const double size = rest.norm();
  for (int pass = 0; pass < 2; ++pass) {
    const VectorXd found = Q.transpose() * rest;
    rest -= Q * found;
    along += found;
  }
  const double across = rest.norm();
  if (!(across > is_dependent * size)) return false;
  Q_.col(n) = rest / across;
  R_.col(n).head(n) = along;
  R_(n, n) = across;
  chosen_.push_back(column);
  return true;
}

void ChosenColumns::remove(std::size_t k) {
  const Index last = count() - 1;
  for (Index j = static_cast<Index>(k); j < last; ++j) {
    R_.col(j).head(j + 2) = R_.col(j + 1).head(j + 2);
    const double r = Eigen::Vector2d(R_(j, j), R_(j + 1, j)).norm(), c = R_(j, j) / r, s = R_(j + 1, j) / r;
    R_(j, j) = r;
    R_(j + 1, j) = 0;
    for (Index i = j + 2; i <= last; ++i) {
      const double upper = R_(j, i), lower = R_(j + 1, i);
      R_(j, i) = c * upper + s * lower;
      R_(j + 1, i) = c * lower - s * upper;
    }
    const VectorXd before = Q_.col(j);
    Q_.col(j) = c * before + s * Q_.col(j + 1);
    Q_.col(j + 1) = c * Q_.col(j + 1) - s * before;
  }
  chosen_.erase(chosen_.begin() + static_cast<std::ptrdiff_t>(k));
}

VectorXd ChosenColumns::solve(const VectorXd& b) const {
  const Index n = count();
  return R_.topLeftCorner(n, n).triangularView<Eigen::Upper>().solve(Q_.leftCols(n).transpose() * b);
}

VectorXd ChosenColumns::nearest(const VectorXd& b) const {
  VectorXd x = solve(b), rest = b;
  for (std::size_t k = 0; k < chosen_.size(); ++k) rest -= x[static_cast<Index>(k)] * A_.col(chosen_[k]);
  return x + solve(rest);
}

}  // namespace touchstone::fast::simultaneous
