// One linear solve with all contact states (open, sticking, slipping) fixed, for when sweeps converge slowly, as they
// do with a heavy body on light ones.
#pragma once

#include <vector>

#include "fast/contact/row.h"

namespace touchstone::fast::contact {

/// Takes from the current impulses which contacts are open (P_n = 0), which stick, and which slip and in which
/// direction. With these states fixed, solves for all P at once:
///   closed  u_n = least_u_n;   sticks  u_t = 0;   slips  P_t = −μ P_n d.
/// An over-determined stack has many solutions; this returns the one nearest to the current P. `twists` are updated.
/// The caller checks with a sweep whether the states were right.
void solve_active_set(std::vector<ContactRow>& rows, const std::vector<Mobility>& bodies, std::vector<Twist>& twists);

}  // namespace touchstone::fast::contact
