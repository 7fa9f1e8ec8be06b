// Vectors and matrices of rational numbers, of any size.
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace touchstone::reference {

using RationalVector = std::vector<mpq_class>;
using RationalMatrix = std::vector<RationalVector>;  ///< by rows

inline mpq_class inner(const RationalVector& a, const RationalVector& b) {
  mpq_class sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

inline RationalVector times(const RationalMatrix& A, const RationalVector& x) {
  RationalVector product;
  for (const RationalVector& row : A) product.push_back(inner(row, x));
  return product;
}

/// The rows and columns of a square matrix that `rows` names.
inline RationalMatrix part(const RationalMatrix& A, const std::vector<std::size_t>& rows) {
  RationalMatrix some;
  for (const std::size_t i : rows) {
    RationalVector& line = some.emplace_back();
    for (const std::size_t j : rows) line.push_back(A[i][j]);
  }
  return some;
}

/// x with A x = b. None if A is singular.
std::optional<RationalVector> solution(RationalMatrix A, const RationalVector& b);

/// A body's number as an index of a vector.
inline std::size_t index(int body) { return static_cast<std::size_t>(body); }

}  // namespace touchstone::reference
