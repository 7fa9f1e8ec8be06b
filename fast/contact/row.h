// A contact point in the solver's equations: which impulse acts there, and what velocities it changes.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "model/frame.h"

namespace touchstone::fast::contact {

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
struct ContactRow {
  int a = 0, b = 0;
  Vec3 n = Vec3::Zero();      ///< unit, from B to A
  Vec3 arm_A = Vec3::Zero();  ///< from A's centre of mass to C
  Vec3 arm_B = Vec3::Zero();
  double friction = 0;
  double least_u_n = 0;   ///< lower bound of u_n after the step (m/s)
  Vec3 P = Vec3::Zero();  ///< initial guess, then result (N s)

  Vec3 K_n = Vec3::Zero();    ///< 1/kg; the velocity u that a unit impulse along n adds
  double K_nn = 0, K_tt = 0;  ///< 1/kg; K_tt: the greater eigenvalue of the tangential block
};

/// Computes K_n, K_nn and K_tt from the arms and the bodies.
void prepare(ContactRow& row, const std::vector<Mobility>& bodies);

/// Adds to `twists` the effect of an impulse P on A at C and −P on B.
inline void apply_impulse(const ContactRow& row, const Vec3& P, const std::vector<Mobility>& bodies,
                          std::vector<Twist>& twists) {
  const Mobility &A = bodies[index(row.a)], &B = bodies[index(row.b)];
  Twist &of_A = twists[index(row.a)], &of_B = twists[index(row.b)];
  of_A.v += A.inverse_mass * P;
  of_A.w += A.inverse_inertia * row.arm_A.cross(P);
  of_B.v -= B.inverse_mass * P;
  of_B.w -= B.inverse_inertia * row.arm_B.cross(P);
}

/// u of the twists (m/s).
inline Vec3 relative_velocity(const ContactRow& row, const std::vector<Twist>& twists) {
  const Twist &A = twists[index(row.a)], &B = twists[index(row.b)];
  return A.v + A.w.cross(row.arm_A) - B.v - B.w.cross(row.arm_B);
}

/// Whether P_t is inside of the friction disc, by more than 2⁻²⁰ of its radius μ P_n. On its rim the contact slips.
bool sticks(const ContactRow& row);

}  // namespace touchstone::fast::contact
