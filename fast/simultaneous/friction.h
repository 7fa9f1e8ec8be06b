// Friction of several regions at one instant: each rubs at its centre of pressure.
#pragma once

#include <vector>

#include "fast/simultaneous/round.h"

namespace touchstone::fast::simultaneous {

/// The part of an impulse P across n (N s).
inline Vec3 friction_of(const contact::ContactRow& row) { return row.P - row.n.dot(row.P) * row.n; }

/// For each region one contact point, its centre of pressure Σ p r / Σ p, with the sum of its points' impulses.
/// `points` are those of all regions, in order, with normal impulses p ≥ 0. The centre of a region without impulse is
/// its first point.
std::vector<contact::ContactRow> centres_of_pressure(const std::vector<Region>& regions,
                                                     const std::vector<contact::ContactRow>& points,
                                                     const std::vector<contact::Mobility>& bodies);

/// Changes the friction at the centres, with their normal impulses P_n, to that which leaves the least kinetic energy
/// of all P_t in the discs |P_t| ≤ μ P_n. So P_t is opposite to the slip u_t that is left, where P_t is on the rim,
/// and u_t = 0 elsewhere. The velocities are unique; P_t is not where regions are redundant. `twists` include the
/// effect of P on entry and on return.
///
/// By projected gradients with Nesterov's acceleration, which restarts where it turns back (O'Donoghue & Candès 2015).
/// All centres move at once. So their order changes no more than rounding, even if 400 steps have not converged.
void add_friction(std::vector<contact::ContactRow>& centres, const std::vector<contact::Mobility>& bodies,
                  std::vector<contact::Twist>& twists);

/// Distributes the friction of each centre over the points of its region in proportion to their normal impulses. The
/// effect on the bodies is the same.
void share_friction(const std::vector<Region>& regions, const std::vector<contact::ContactRow>& centres,
                    std::vector<contact::ContactRow>& points);

}  // namespace touchstone::fast::simultaneous
