// Solves all contacts at once: by sweeps where they converge fast, otherwise by Newton's method.
#pragma once

#include <vector>

#include "fast/contact/solver.h"

namespace touchstone::fast::contact {

/// The problem of `solve` (solver.h). By sweeps as long as they converge fast, as they do where few contacts lie above
/// one another. From where they led by Newton's method (sparse/newton.h), and then by more sweeps; at last by Newton's
/// method from the impulses of bonded contacts. If none of them converges, P are those of the last sweeps or of
/// Newton's method after them.
void solve_combined(std::vector<ContactRow>& rows, const std::vector<Mobility>& mobilities, std::vector<Twist>& twists,
                    SolverLimits sweeps);

}  // namespace touchstone::fast::contact
