#include "fast/simultaneous/nonnegative.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "fast/simultaneous/chosen_columns.h"

namespace touchstone::fast::simultaneous {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double is_dependent = 0x1p-36;  // sine of a column's angle to the span of others
constexpr double rounding = 0x1p-46;      // of |A_j| and the terms of b - A x: a smaller slope is 0
constexpr Index rounds_per_column = 8;    // in exact arithmetic the method ends; here it ends after that many

/// The column along which the distance falls fastest, if it does; `rest` is b − A x.
std::optional<Index> steepest(const MatrixXd& A, const VectorXd& sizes, const VectorXd& rest, double least,
                              const std::vector<bool>& left_out) {
  const VectorXd slopes = A.transpose() * rest;
  std::optional<Index> found;
  for (Index j = 0; j < A.cols(); ++j) {
    if (!(sizes[j] > 0) || left_out[static_cast<std::size_t>(j)]) continue;
    const double slope = slopes[j] / sizes[j];
    if (slope > least) found = j, least = slope;
  }
  return found;
}

/// Moves x to the solution over the chosen columns, without the columns whose entries reach 0 on the way, which are
/// removed. Returns how far it moved, as a share of the ways.
double descend(const VectorXd& b, ChosenColumns& positive, VectorXd& x) {
  double moved = 0;
  while (!positive.chosen().empty()) {
    const std::vector<Index>& chosen = positive.chosen();
    const VectorXd z = positive.nearest(b);
    double share = 1;
    std::size_t first = chosen.size();
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      const double now = x[chosen[k]], next = z[static_cast<Index>(k)];
      const double reaches = now > 0 ? now / (now - next) : 0;
      if (!(next > 0) && (first == chosen.size() || reaches < share)) share = reaches, first = k;
    }
    for (std::size_t k = 0; k < chosen.size(); ++k)
      x[chosen[k]] = std::max(0.0, x[chosen[k]] + share * (z[static_cast<Index>(k)] - x[chosen[k]]));
    moved += share;
    if (first == chosen.size()) break;
    x[chosen[first]] = 0;
    positive.remove(first);
  }
  return moved;
}

}  // namespace

VectorXd nonnegative_least_squares(const MatrixXd& A, const VectorXd& b, const VectorXd& start) {
  VectorXd x = VectorXd::Zero(A.cols());
  const VectorXd sizes = A.colwise().norm();
  ChosenColumns positive(A);
  for (Index j = 0; j < start.size(); ++j) {
    if (start[j] > 0 && positive.add(j, is_dependent)) x[j] = start[j];
  }
  descend(b, positive, x);
  std::vector<bool> refused(static_cast<std::size_t>(A.cols()), false);
  for (Index round = 0; round < rounds_per_column * A.cols(); ++round) {
    const double terms = b.norm() + sizes.dot(x);
    std::vector<bool> left_out = refused;
    for (const Index j : positive.chosen()) left_out[static_cast<std::size_t>(j)] = true;
    const std::optional<Index> entering = steepest(A, sizes, b - A * x, rounding * terms, left_out);
    if (!entering) break;
    refused[static_cast<std::size_t>(*entering)] = true;
    if (!positive.add(*entering, is_dependent)) continue;
    if (descend(b, positive, x) > 0) refused.assign(refused.size(), false);
  }
  return x;
}

}  // namespace touchstone::fast::simultaneous
