#include "reference/simultaneous/lemke.h"

#include <cstddef>
#include <utility>

namespace touchstone::reference {
namespace {

/// Columns of `rows`: w (n of them), z (n), the artificial variable, and the right-hand side.
struct Tableau {
  Tableau(const RationalMatrix& M, const RationalVector& q) : n(q.size()) {
    for (std::size_t i = 0; i < n; ++i) {
      RationalVector& row = rows.emplace_back(2 * n + 2);
      row[i] = 1;
      for (std::size_t j = 0; j < n; ++j) row[n + j] = -M[i][j];
      row[artificial()] = -1;
      row.back() = q[i];
      basis.push_back(i);
    }
  }

  std::size_t artificial() const { return 2 * n; }
  std::size_t partner(std::size_t variable) const { return variable < n ? variable + n : variable - n; }

  /// Compares (right-hand side, columns of w) of row i over a with those of row k over b.
  bool is_less(std::size_t i, const mpq_class& a, std::size_t k, const mpq_class& b) const {
    const mpq_class here = rows[i].back() / a, there = rows[k].back() / b;
    if (here != there) return here < there;
    for (std::size_t j = 0; j < n; ++j) {
      const mpq_class left = rows[i][j] / a, right = rows[k][j] / b;
      if (left != right) return left < right;
    }
    return false;
  }

  void pivot(std::size_t at, std::size_t entering) {
    const mpq_class factor = rows[at][entering];
    for (mpq_class& x : rows[at]) x /= factor;
    for (std::size_t i = 0; i < n; ++i) {
      if (i == at || sgn(rows[i][entering]) == 0) continue;
      const mpq_class part = rows[i][entering];
      for (std::size_t j = 0; j < rows[i].size(); ++j) rows[i][j] -= part * rows[at][j];
    }
    basis[at] = entering;
  }

  std::size_t n;
  RationalMatrix rows;
  std::vector<std::size_t> basis;
};

}  // namespace

std::optional<RationalVector> linear_complementarity(const RationalMatrix& M, const RationalVector& q) {
  Tableau tableau(M, q);
  const std::size_t n = tableau.n;
  RationalVector z(n);
  std::size_t leaves = 0;
  for (std::size_t i = 1; i < n; ++i) {
    if (tableau.is_less(i, 1, leaves, 1)) leaves = i;
  }
  if (n == 0 || sgn(q[leaves]) >= 0) return z;
  std::size_t entering = tableau.artificial();
  while (true) {
    const std::size_t left = tableau.basis[leaves];
    tableau.pivot(leaves, entering);
    if (left == tableau.artificial()) break;
    entering = tableau.partner(left);
    std::optional<std::size_t> next;
    for (std::size_t i = 0; i < n; ++i) {
      if (sgn(tableau.rows[i][entering]) <= 0) continue;
      if (!next || tableau.is_less(i, tableau.rows[i][entering], *next, tableau.rows[*next][entering])) next = i;
    }
    if (!next) return std::nullopt;
    leaves = *next;
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (tableau.basis[i] >= n && tableau.basis[i] < 2 * n) z[tableau.basis[i] - n] = tableau.rows[i].back();
  }
  return z;
}

}  // namespace touchstone::reference
