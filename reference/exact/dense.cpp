#include "reference/exact/dense.h"

#include <algorithm>

namespace touchstone::reference {

std::optional<RationalVector> solution(RationalMatrix A, const RationalVector& b) {
  const std::size_t n = b.size();
  for (std::size_t i = 0; i < n; ++i) A[i].push_back(b[i]);
  for (std::size_t k = 0; k < n; ++k) {
    const auto pivot = std::find_if(A.begin() + static_cast<std::ptrdiff_t>(k), A.end(),
                                    [&](const RationalVector& row) { return sgn(row[k]) != 0; });
    if (pivot == A.end()) return std::nullopt;
    std::iter_swap(A.begin() + static_cast<std::ptrdiff_t>(k), pivot);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k || sgn(A[i][k]) == 0) continue;
      const mpq_class factor = A[i][k] / A[k][k];
      for (std::size_t j = k; j <= n; ++j) A[i][j] -= factor * A[k][j];
    }
  }
  RationalVector x;
  for (std::size_t i = 0; i < n; ++i) x.emplace_back(A[i][n] / A[i][i]);
  return x;
}

}  // namespace touchstone::reference
