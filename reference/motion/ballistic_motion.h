// The ballistic (torque-free) motion of one body, in either interval arithmetic.
//
// A reference point (the centre of mass; for a fixed body its origin) moves as p + v τ + ½ c τ². Unless all three
// moments of inertia differ, the body turns by
//   R(τ) = exp([Ω] τ) R(0) exp([σ] τ),   Ω in W, σ in the body's axes, both constant:
// I = λ 1, or a fixed body: Ω = ω, σ = 0, a screw. Two equal moments λ, with D = I − λ 1 of rank 1: ω = L/λ − (D ω)/λ,
// where the angular momentum L is constant and D ω keeps its length along the body's own axis; so Ω = L/λ and σ = −D
// ω_B/λ.
// All of these are rational. Otherwise the body tumbles (reference/motion/tumble.h).
#pragma once

#include <gmpxx.h>

#include <memory>
#include <optional>
#include <string>

#include "model/scene.h"
#include "reference/exact/quaternion.h"
#include "reference/exact/tiers.h"
#include "reference/motion/moving_mass.h"
#include "reference/motion/tumble.h"

namespace touchstone::reference {

/// The exact initial state of a ballistic motion, and its constants.
struct BallisticStart {
  mpq_class start_time;  ///< s
  Triple centre;         ///< of the reference point, in B
  Triple p, v, c;        ///< its position, velocity and acceleration, in W
  std::array<mpq_class, 4> q;
  mpq_class q_squared;                   ///< |q|²
  Triple w;                              ///< in W
  Triple Omega, sigma;                   ///< see above
  std::shared_ptr<const Tumble> tumble;  ///< if the body tumbles; Omega and sigma are then not used
  bool pi = false;                       ///< a rational replaces π in centre and c
};

/// Requires a completed scene with a motion. Throws InputError if an applied force of the body begins after its start,
/// and whatever moving_mass() throws.
BallisticStart ballistic_start(const Scene& scene, std::size_t body);

/// The state at one time, in W's axes.
template <class E>
struct BallisticState {
  Coordinates<E> p, v;  ///< of the reference point
  Coordinates<E> w;
  Rotor<E> q;          ///< of R
  std::array<E, 9> R;  ///< R_WB
};

template <class E>
Coordinates<E> turned(const std::array<E, 9>& R, const Coordinates<E>& r) {
  return {E(R[0] * r.x + R[1] * r.y + R[2] * r.z), E(R[3] * r.x + R[4] * r.y + R[5] * r.z),
          E(R[6] * r.x + R[7] * r.y + R[8] * r.z)};
}

template <class E>
Coordinates<E> turned_back(const std::array<E, 9>& R, const Coordinates<E>& r) {
  return {E(R[0] * r.x + R[3] * r.y + R[6] * r.z), E(R[1] * r.x + R[4] * r.y + R[7] * r.z),
          E(R[2] * r.x + R[5] * r.y + R[8] * r.z)};
}

/// A BallisticStart with its constants enclosed. Call every member function inside the tier's scope.
template <class Tier>
class RigidBodyModel {
 public:
  using E = typename Tier::E;
  using P = typename Tier::P;

  explicit RigidBodyModel(const BallisticStart& start);

  BallisticState<E> at(const E& time) const;

  const Coordinates<E>& centre() const { return centre_; }
  const Coordinates<E>& acceleration() const { return c_; }  ///< of the reference point

  /// ≥ |ω|² + |ω'| at all times. So the acceleration of a point at r from the reference point differs from that of the
  /// reference point by at most this times |r|. Infinite where nothing is known.
  const E& turning() const { return turning_; }

 private:
  E start_time_, q_squared_;
  Coordinates<E> centre_, p_, v_, c_;
  Rotor<E> q_;
  Spin<E> outer_, inner_;
  E turning_;
  std::shared_ptr<const Tumble> tumble_;
};

}  // namespace touchstone::reference
