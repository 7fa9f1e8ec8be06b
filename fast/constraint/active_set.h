// Where sweeps crawl, as under a heavy body on light ones: one linear solve with the contacts' states held.
#pragma once

#include <vector>

#include "fast/constraint/solve.h"

namespace touchstone::fast::constraint {

/// Holds who is open (P_n = 0), who sticks and who slips, and in which direction, and solves for all P at once:
///   closed  u_n = least_u_n;   sticks  u_t = 0;   slips  P_t = −μ P_n d.
/// Of the many solutions of an over-determined stack, the one nearest to the P that are there. `twists` follow. The
/// caller sees by a sweep whether the states were right.
void jump(std::vector<Touch>& touches, const std::vector<Mobility>& bodies, std::vector<Twist>& twists);

}  // namespace touchstone::fast::constraint
