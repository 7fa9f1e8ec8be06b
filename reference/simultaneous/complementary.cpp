#include "reference/simultaneous/complementary.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace touchstone::reference {
namespace {

/// x with K_SS x = −u_S for the rows and columns S. None if K_SS is singular. K_SS is semidefinite, so that a pivot on
/// the diagonal is 0 only if it is.
std::optional<RationalVector> solved(const RationalMatrix& K, const RationalVector& u,
                                     const std::vector<std::size_t>& S) {
  RationalMatrix rows;
  for (const std::size_t i : S) {
    RationalVector row;
    for (const std::size_t j : S) row.push_back(K[i][j]);
    row.emplace_back(-u[i]);
    rows.push_back(std::move(row));
  }
  for (std::size_t pivot = 0; pivot < rows.size(); ++pivot) {
    if (sgn(rows[pivot][pivot]) == 0) return std::nullopt;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i == pivot) continue;
      const mpq_class factor = rows[i][pivot] / rows[pivot][pivot];
      for (std::size_t j = pivot; j < rows[i].size(); ++j) rows[i][j] -= factor * rows[pivot][j];
    }
  }
  RationalVector x;
  for (std::size_t i = 0; i < rows.size(); ++i) x.emplace_back(rows[i].back() / rows[i][i]);
  return x;
}

/// The index of the greatest approach, u + K p < 0; none if nothing approaches.
std::optional<std::size_t> fastest(const RationalMatrix& K, const RationalVector& u, const RationalVector& p) {
  std::optional<std::size_t> found;
  mpq_class least = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const mpq_class after = u[i] + inner(K[i], p);
    if (after < least) {
      least = after;
      found = i;
    }
  }
  return found;
}

}  // namespace

std::optional<RationalVector> complementary(const RationalMatrix& K, const RationalVector& u) {
  RationalVector p(u.size());
  std::vector<std::size_t> pressing;
  while (const std::optional<std::size_t> next = fastest(K, u, p)) {
    pressing.push_back(*next);
    while (true) {
      const std::optional<RationalVector> wanted = solved(K, u, pressing);
      if (!wanted) return std::nullopt;
      // The greatest part of the way at which no impulse is negative.
      mpq_class part = 1;
      for (std::size_t k = 0; k < pressing.size(); ++k) {
        const mpq_class& now = p[pressing[k]];
        if (sgn((*wanted)[k]) < 0) part = std::min(part, mpq_class(now / (now - (*wanted)[k])));
      }
      for (std::size_t k = 0; k < pressing.size(); ++k) p[pressing[k]] += part * ((*wanted)[k] - p[pressing[k]]);
      std::erase_if(pressing, [&](std::size_t i) { return sgn(p[i]) == 0; });
      if (part == 1) break;
    }
  }
  return p;
}

}  // namespace touchstone::reference
