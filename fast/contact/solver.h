// Solves all contacts of a step at once: complementarity and Coulomb's cone, by projected Gauss-Seidel.
#pragma once

#include <cstddef>
#include <vector>

#include "fast/contact/row.h"

namespace touchstone::fast::contact {

/// When to stop, and when to try the active set.
struct SolverLimits {
  int sweeps = 200;
  int sweeps_per_active_set = 16;
  std::size_t most_active_set_contacts = 16;  ///< it costs their cube
  double enough = 0;                          ///< m/s; a smaller change of velocity counts as converged
  bool is_patient = true;                     ///< otherwise sweeps end too when they converge slowly
};

/// Finds P for all contacts: P_n ≥ 0 and u_n ≥ least_u_n, with equality in at least one of the two; P_t in the disc of
/// radius μ P_n, and opposite to u_t where it is on the rim. On entry `twists` do not include the effect of the initial
/// P; on return they include the effect of the final P. Each sweep solves the contacts one after the other, the
/// friction disc as a whole (no pyramid). Sweeps end when none of a sweep's changes of velocity exceeds 2⁻⁴⁴ of the
/// greatest velocity, or `enough`. Between sweeps P is extrapolated along a conjugate direction. After every
/// `sweeps_per_active_set` sweeps an active-set solve (active_set.h) is tried; it is undone if the next sweep changes
/// no less than the one before. Unless they are patient, sweeps end too when the least change of 32 of them is more
/// than a quarter of that of the 32 before: at this rate 400 sweeps do not reach the tolerance. Returns whether they
/// converged.
bool solve(std::vector<ContactRow>& rows, const std::vector<Mobility>& bodies, std::vector<Twist>& twists,
           const SolverLimits& limits);

/// How much a velocity at the contact would change if its impulse were corrected once for the relative velocity u
/// (m/s); 0 exactly if P and u satisfy the contact's conditions. With s = u_n − least_u_n and D the disc of radius
/// μ max(P_n, 0):
///
///   max(|min(K_nn P_n, s)|, K_tt |P_t − nearest point of D to (P_t − u_t/K_tt)|)
///
/// This is the natural residual of the complementarity problem and of the friction disc (Acary & Brogliato 2008).
double residual(const ContactRow& row, const Vec3& u);

}  // namespace touchstone::fast::contact
