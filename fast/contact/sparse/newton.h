// Solves many contacts at once by a semismooth Newton method on the bodies' twists.
#pragma once

#include <vector>

#include "fast/contact/row.h"

namespace touchstone::fast::contact {

/// When to stop.
struct NewtonLimits {
  double enough = 0;  ///< m/s; a smaller residual counts as converged
  int factorisations = 160;
};

/// The problem of `solve` (solver.h), for islands in which sweeps would take thousands. On entry `twists` do not
/// include the effect of the initial P; on return they include that of the final P. Returns whether no contact's
/// residual exceeds `enough` (m/s) or what rounding explains; otherwise P and `twists` are the best ones found.
///
/// Augmented Lagrangian of Alart & Curnier 1991: with Q(P, v) = nearest_in_disc(P − ρ k (u − least_u_n n)) and k the
/// effective mass at a contact, each round solves M (v − v_free) = GᵀQ(P, v) for the twists v, and then takes Q as P.
/// So momentum is exact, and only the conditions at contacts are missed. A round whose Newton steps do not converge is
/// repeated with a smaller ρ; one that converges makes ρ larger. After each round the states that contacts have then
/// (open, sticking, slipping) are kept for one linear solve with a far larger ρ, whose result counts if its residual is
/// at most half as large. The first P are the given ones; if all are 0, those of bonded contacts, cut to the friction
/// discs. Coulomb's problem is not monotone, so convergence has no proof.
bool solve_newton(std::vector<ContactRow>& rows, const std::vector<Mobility>& bodies, std::vector<Twist>& twists,
                  const NewtonLimits& limits);

}  // namespace touchstone::fast::contact
