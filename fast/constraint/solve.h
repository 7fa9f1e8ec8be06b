// Solves all contacts of a step at once: complementarity and Coulomb's cone, by projected Gauss-Seidel.
#pragma once

#include <cstddef>
#include <vector>

#include "model/frame.h"

namespace touchstone::fast::constraint {

/// Bodies and contacts are numbered by int, containers by std::size_t.
inline std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// Velocity of the centre of mass (of the origin, if the body is fixed) and angular velocity, in W.
struct Twist {
  Vec3 v = Vec3::Zero();
  Vec3 w = Vec3::Zero();
};

/// The response of a body to an impulse; zero if it is fixed.
struct Mobility {
  double inverse_mass = 0;
  Mat3 inverse_inertia = Mat3::Zero();  ///< about the centre of mass, in W
};

/// One contact point in a step. An impulse P on A at C, and −P on B, changes u by K P, where u is the velocity of A's
/// point at C relative to B's.
struct Touch {
  int a = 0, b = 0;
  Vec3 n = Vec3::Zero();      ///< unit, from B to A
  Vec3 arm_A = Vec3::Zero();  ///< from A's centre of mass to C
  Vec3 arm_B = Vec3::Zero();
  double friction = 0;
  double least_u_n = 0;   ///< lower bound of u_n after the step (m/s)
  Vec3 P = Vec3::Zero();  ///< initial guess, then result (N s)

  double K_nn = 0, K_tt = 0;  ///< 1/kg; K_tt: the greater eigenvalue of the tangential block
};

/// Computes K_nn and K_tt from the arms and the bodies.
void prepare(Touch& touch, const std::vector<Mobility>& bodies);

/// Adds to `twists` the effect of an impulse P on A at C and −P on B.
void push(const Touch& touch, const Vec3& P, const std::vector<Mobility>& bodies, std::vector<Twist>& twists);

Vec3 relative_velocity(const Touch& touch, const std::vector<Twist>& twists);

/// When to stop, and when to try the active set.
struct Effort {
  int sweeps = 200;
  int sweeps_per_active_set = 16;
  std::size_t most_active_set_contacts = 64;  ///< it costs their cube
  double enough = 0;                          ///< m/s; a smaller change of velocity counts as converged
};

/// Finds P for all contacts: P_n ≥ 0 and u_n ≥ least_u_n, with equality in at least one of the two; P_t in the disc of
/// radius μ P_n, and opposite to u_t where it is on the rim. On entry `twists` do not include the effect of the initial
/// P; on return they include the effect of the final P. Each sweep solves the contacts one after the other, the
/// friction disc as a whole (no pyramid). Sweeps end when none of a sweep's changes of velocity exceeds 2⁻⁴⁴ of the
/// greatest velocity, or `enough`. Between sweeps P is extrapolated along a conjugate direction. After every
/// `sweeps_per_active_set` sweeps an active-set solve (active_set.h) is tried; it is undone if the next sweep changes
/// no less than the one before.
void solve(std::vector<Touch>& touches, const std::vector<Mobility>& bodies, std::vector<Twist>& twists,
           const Effort& effort);

}  // namespace touchstone::fast::constraint
