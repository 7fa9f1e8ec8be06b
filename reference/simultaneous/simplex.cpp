#include "reference/simultaneous/simplex.h"

#include "reference/simultaneous/lemke.h"

namespace touchstone::reference {

// With a multiplier t = t⁺ − t⁻ of Σ λ = 1: Qλ − t ≥ 0, complementary to λ, and λᵀQλ = t.
mpq_class least_on_simplex(const RationalMatrix& Q) {
  const std::size_t n = Q.size();
  RationalMatrix M(n + 2, RationalVector(n + 2));
  RationalVector q(n + 2);
  q[n] = -1;
  q[n + 1] = 1;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) M[i][j] = Q[i][j];
    M[i][n] = M[n + 1][i] = -1;
    M[i][n + 1] = M[n][i] = 1;
  }
  const RationalVector z = linear_complementarity(M, q).value();  // the simplex is compact, so there is a least value
  return z[n] - z[n + 1];
}

}  // namespace touchstone::reference
