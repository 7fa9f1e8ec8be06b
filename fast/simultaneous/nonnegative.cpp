#include "fast/simultaneous/nonnegative.h"

#include <Eigen/QR>
#include <algorithm>
#include <optional>
#include <vector>

namespace touchstone::fast::simultaneous {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double is_dependent = 0x1p-36;  // sine of a column's angle to the span of others
constexpr double rounding = 0x1p-46;      // of |A_j| and the terms of b - A x: a smaller slope is 0
constexpr Index rounds_per_column = 8;    // in exact arithmetic the method ends; here it ends after that many

/// The solution over the columns `of`, with one step of refinement.
VectorXd solution(const MatrixXd& A, const std::vector<Index>& of, const VectorXd& b) {
  MatrixXd some(A.rows(), static_cast<Index>(of.size()));
  for (std::size_t k = 0; k < of.size(); ++k) some.col(static_cast<Index>(k)) = A.col(of[k]);
  const Eigen::HouseholderQR<MatrixXd> qr(some);
  VectorXd x = qr.solve(b);
  x += qr.solve(b - some * x);
  return x;
}

/// Whether the column is independent of the columns `of`.
bool is_independent(const MatrixXd& A, const std::vector<Index>& of, Index column) {
  if (of.empty()) return true;
  if (static_cast<Index>(of.size()) >= A.rows()) return false;
  const VectorXd target = A.col(column);
  VectorXd rest = target;
  const VectorXd x = solution(A, of, target);
  for (std::size_t k = 0; k < of.size(); ++k) rest -= x[static_cast<Index>(k)] * A.col(of[k]);
  return rest.norm() > is_dependent * target.norm();
}

/// The column along which the distance falls fastest, if it does; `rest` is b − A x.
std::optional<Index> steepest(const MatrixXd& A, const VectorXd& rest, double least, const std::vector<Index>& positive,
                              const std::vector<bool>& refused) {
  std::optional<Index> found;
  for (Index j = 0; j < A.cols(); ++j) {
    const double size = A.col(j).norm();
    if (!(size > 0) || refused[static_cast<std::size_t>(j)] || std::ranges::count(positive, j) > 0) continue;
    const double slope = A.col(j).dot(rest) / size;
    if (slope > least) found = j, least = slope;
  }
  return found;
}

/// Moves x to the solution over the columns `positive`, without the columns whose entries reach 0 on the way, which are
/// removed. Returns how far it moved, as a share of the ways.
double descend(const MatrixXd& A, const VectorXd& b, std::vector<Index>& positive, VectorXd& x) {
  double moved = 0;
  while (!positive.empty()) {
    const VectorXd z = solution(A, positive, b);
    double share = 1;
    std::size_t first = positive.size();
    for (std::size_t k = 0; k < positive.size(); ++k) {
      const double now = x[positive[k]], next = z[static_cast<Index>(k)];
      const double reaches = now > 0 ? now / (now - next) : 0;
      if (!(next > 0) && (first == positive.size() || reaches < share)) share = reaches, first = k;
    }
    for (std::size_t k = 0; k < positive.size(); ++k)
      x[positive[k]] = std::max(0.0, x[positive[k]] + share * (z[static_cast<Index>(k)] - x[positive[k]]));
    moved += share;
    if (first == positive.size()) break;
    x[positive[first]] = 0;
    positive.erase(positive.begin() + static_cast<std::ptrdiff_t>(first));
  }
  return moved;
}

}  // namespace

VectorXd nonnegative_least_squares(const MatrixXd& A, const VectorXd& b) {
  VectorXd x = VectorXd::Zero(A.cols());
  std::vector<Index> positive;  // the columns whose entries may be positive
  std::vector<bool> refused(static_cast<std::size_t>(A.cols()), false);
  for (Index round = 0; round < rounds_per_column * A.cols(); ++round) {
    const double terms = b.norm() + A.colwise().norm() * x;
    const std::optional<Index> entering = steepest(A, b - A * x, rounding * terms, positive, refused);
    if (!entering) break;
    refused[static_cast<std::size_t>(*entering)] = true;
    if (!is_independent(A, positive, *entering)) continue;
    positive.push_back(*entering);
    if (descend(A, b, positive, x) > 0) refused.assign(refused.size(), false);
  }
  return x;
}

}  // namespace touchstone::fast::simultaneous
