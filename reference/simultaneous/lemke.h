// The linear complementarity problem with any matrix.
#pragma once

#include <optional>

#include "reference/exact/dense.h"

namespace touchstone::reference {

/// z ≥ 0 with w = M z + q ≥ 0 and z·w = 0, by pivoting (Lemke 1965). Exact; degenerate steps are decided in the
/// lexicographic order, so it ends (Cottle, Pang & Stone 1992, section 4.9). None if it ends on a ray: for a positive
/// semidefinite M (not necessarily symmetric), there is no z then; for another M there may be one.
std::optional<RationalVector> linear_complementarity(const RationalMatrix& M, const RationalVector& q);

}  // namespace touchstone::reference
