// Do contact forces exist that hold bodies at rest? Proofs of either answer, checked in exact numbers without a solver.
#pragma once

#include <optional>
#include <vector>

#include "reference/impulse.h"

namespace touchstone::reference {

/// Bodies under loads and the points at which they touch. Doubles are read as the numbers they are.
struct LoadedBodies {
  /// Force (N) through the centre of mass, and torque (N m) about it, in W.
  struct Load {
    Vec3 force_W = Vec3::Zero();
    Vec3 torque_W = Vec3::Zero();
  };
  /// The force P acts on A at arm_A from its centre of mass, and −P on B at arm_B.
  struct Point {
    int a = 0, b = 0;
    Vec3 nhat_BA_W = Vec3::Zero();  ///< of any length but 0, from B to A
    Vec3 arm_A_W = Vec3::Zero(), arm_B_W = Vec3::Zero();
    double friction = 0;
  };
  std::vector<std::optional<Load>> loads;  ///< by body; none: it is fixed
  std::vector<Point> points;
};

/// Do these forces on A at the points balance the loads, each within its friction cone? Then the bodies stand.
/// Exact: f + GᵀP = 0 for each body that moves; with N the normal as given, P·N ≥ 0 and |N|²|P|² ≤ (1 + μ²)(P·N)².
bool proves_standing(const LoadedBodies& bodies, const std::vector<ExactVec3>& P_A_W);

/// Do the loads do work along this motion, in which no point approaches, or slips by more than u_n ≥ μ |u_t| allows?
/// Then no forces within the cones balance the loads: these would do work P·u ≥ 0, and the sum would not be 0 (Farkas).
/// Exact: Σ f·d > 0; with U = u·N, U ≥ 0 and (1 + μ²) U² ≥ μ² |N|²|u|².
bool proves_falling(const LoadedBodies& bodies, const std::vector<ExactVelocity>& motion);

/// Forces near the given ones that balance the loads exactly. None if the points inside of their cones do not hold each
/// body to another or a fixed one in all six directions. They may lie outside of their cones: `proves_standing`
/// decides.
///
/// All friction is first reduced by the part `inwards` of itself, since a solver leaves points that slip on their
/// cones. Then each body hands what is left of its load down a tree that is rooted in the fixed bodies, through all
/// points of the pair that lie inside of their cones: δP = w (z_v + z_ω × arm), w a power of two below the distance to
/// the cone's surface, and z the rational solution of six linear equations.
std::optional<std::vector<ExactVec3>> balanced(const LoadedBodies& bodies, const std::vector<Vec3>& P_A_W,
                                               double inwards);

}  // namespace touchstone::reference
