// The linear complementarity problem of contact points without friction.
#pragma once

#include <optional>

#include "reference/exact/dense.h"

namespace touchstone::reference {

/// The normal impulses p ≥ 0 with u + K p ≥ 0 and p·(u + K p) = 0, where u are the normal velocities before, and K is
/// symmetric positive semidefinite. For K = N M⁻¹ Nᵀ they lead from the velocities before to the nearest in kinetic
/// energy at which nothing approaches (Moreau 1988); those are unique, p is not where K is singular. None if no
/// velocities are such: bodies between which another one is clamped.
/// Exact: the active-set method of Lawson & Hanson (1974), which ends since each active set has less energy than the
/// one before.
std::optional<RationalVector> complementary(const RationalMatrix& K, const RationalVector& u);

}  // namespace touchstone::reference
