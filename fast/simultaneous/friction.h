// Friction at given normal impulses.
#pragma once

#include <vector>

#include "fast/contact/row.h"

namespace touchstone::fast::simultaneous {

/// The part of an impulse P across n (N s).
inline Vec3 friction_of(const contact::ContactRow& row) { return row.P - row.n.dot(row.P) * row.n; }

/// Changes the friction P_t of contact points, whose normal impulses P_n stay, to that which leaves the least kinetic
/// energy of all in the discs |P_t| ≤ μ P_n. So P_t is opposite to the slip u_t that is left, where P_t is on the rim,
/// and u_t = 0 elsewhere. The velocities are unique; P_t is not where points are redundant. `twists` include the effect
/// of P on entry and on return.
///
/// By projected gradients with Nesterov's acceleration, which restarts where it turns back (O'Donoghue & Candès 2015).
/// All points move at once. So their order changes no more than rounding, even if 400 steps have not converged.
void add_friction(std::vector<contact::ContactRow>& rows, const std::vector<contact::Mobility>& bodies,
                  std::vector<contact::Twist>& twists);

}  // namespace touchstone::fast::simultaneous
