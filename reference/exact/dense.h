// Vectors and matrices of rational numbers, of any size.
#pragma once

#include <gmpxx.h>

#include <cstddef>
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

}  // namespace touchstone::reference
