// The least value of a quadratic form over weights that sum to 1.
#pragma once

#include "reference/exact/dense.h"

namespace touchstone::reference {

/// min λᵀQλ over λ ≥ 0, Σ λ = 1, for a symmetric positive semidefinite Q of at least one row. Exact.
mpq_class least_on_simplex(const RationalMatrix& Q);

}  // namespace touchstone::reference
