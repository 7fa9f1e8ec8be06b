// Contact forces that balance what acts on bodies at rest.
#pragma once

#include <optional>
#include <vector>

#include "fast/contact/row.h"

namespace touchstone::fast::contact {

/// Looks for impulses P in the friction cones that bring all bodies to rest, whose twists are those that the loads
/// alone would give them. On return `twists` include the effect of P. They are 0, up to 2⁻³³ of the greatest one, where
/// such P were found. least_u_n is not used, and the first P do not matter.
///
/// Bodies stand if such P exist, also where Coulomb's law allows other motions from rest. So this is a convex problem:
///
///   minimise over y  φ(y) = Σ kᵢ |Π(−Gᵢy)|²/2 − f·y,     P_i = Π(−kᵢGᵢy),
///
/// where Π is the nearest point in a cone, k the effective mass at a contact, f the loads, and y the displacement of
/// elastic supports that cannot pull; ∇φ = 0 is balance. First all cones count as bonded (Π = 1): one linear solve,
/// which ends the search for most stacks. Then semismooth Newton minimises φ(y) + s |y − y_k|²_M/2 with ever smaller s
/// (Rockafellar 1976). The impulses are corrected by P ← Π(P − k G H⁻¹ (f + GᵀP)), since y is large and P is not. The
/// search also ends where y_k runs away along a motion in which no contact approaches or slips more than it opens
/// (u_n ≥ μ |u_t|) and the loads do work: then no P balance them (Farkas' lemma). That motion is returned; it misses
/// the condition by up to 2⁻²³ of its greatest speed.
std::optional<std::vector<Twist>> balance(std::vector<ContactRow>& rows, const std::vector<Mobility>& bodies,
                                          std::vector<Twist>& twists);

}  // namespace touchstone::fast::contact
