// All contacts of a step at once: complementarity and Coulomb's cone, by projected Gauss-Seidel.
#pragma once

#include <vector>

#include "model/frame.h"

namespace touchstone::fast::constraint {

/// A velocity of the centre (of a fixed body: of its origin) and a spin, in W.
struct Twist {
  Vec3 v = Vec3::Zero();
  Vec3 w = Vec3::Zero();
};

/// What an impulse does to a body; nothing, if it is fixed.
struct Mobility {
  double inverse_mass = 0;
  Mat3 inverse_inertia = Mat3::Zero();  ///< about its centre, in W
};

/// One contact point in a step. An impulse P on A at C, −P on B, changes u = A's velocity there against B's by K P.
struct Touch {
  int a = 0, b = 0;
  Vec3 n = Vec3::Zero();      ///< unit, from B to A
  Vec3 arm_A = Vec3::Zero();  ///< from A's centre to C
  Vec3 arm_B = Vec3::Zero();
  double friction = 0;
  double least_u_n = 0;   ///< u_n after is at least this (m/s)
  Vec3 P = Vec3::Zero();  ///< guess, then answer (N s)

  double K_nn = 0, K_tt = 0;  ///< 1/kg; of the tangential block, the greater eigenvalue
};

/// K_nn and K_tt, from the arms and the bodies.
void prepare(Touch& touch, const std::vector<Mobility>& bodies);

/// Adds what an impulse P on A at C, −P on B, does to their twists.
void push(const Touch& touch, const Vec3& P, const std::vector<Mobility>& bodies, std::vector<Twist>& twists);

Vec3 relative_velocity(const Touch& touch, const std::vector<Twist>& twists);

/// How long to go on.
struct Effort {
  int sweeps = 200;
  int sweeps_to_a_jump = 16;
  std::size_t most_that_jump = 64;  ///< contacts: a jump costs their cube
  double enough = 0;                ///< m/s; changes that are no greater do not matter
};

/// Finds P for all touches: P_n ≥ 0, u_n ≥ least_u_n, one of the two equal; P_t in the disc of radius μ P_n, against
/// u_t where it is on its rim. `twists`: with the guesses' effect left out; then with all P's. Each contact is solved
/// in turn, the disc round, until no sweep changes a velocity by more than 2⁻⁴⁴ of the greatest, or by more than is
/// enough. A sweep begins further on along a direction conjugate to the last ones. Where sweeps crawl, so many of them
/// are followed by a jump (active_set.h), which is taken back if the next sweep finds it worse.
void solve(std::vector<Touch>& touches, const std::vector<Mobility>& bodies, std::vector<Twist>& twists,
           const Effort& effort);

}  // namespace touchstone::fast::constraint
