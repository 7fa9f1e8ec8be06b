// The motion of one body in flight, in either interval arithmetic.
//
// A reference point (the centre of mass; a fixed body's origin) moves as p + v τ + ½ c τ². Without two different
// moments of inertia the body turns by
//   R(τ) = exp([Ω] τ) R(0) exp([σ] τ),   Ω in W, σ in the body's axes, both constant:
// I = λ 1 and a fixed body: Ω = ω, σ = 0, a screw. Two equal moments λ, D = I − λ 1 of rank 1: ω = L/λ − (D ω)/λ, where
// the angular momentum L is constant and D ω keeps its length along the body's own axis; so Ω = L/λ and σ = −D ω_B/λ.
// All of these are rational. Else the body tumbles (reference/tumble_impl.h).
#pragma once

#include <gmpxx.h>

#include <memory>
#include <optional>
#include <string>

#include "model/scene.h"
#include "reference/heavy_impl.h"
#include "reference/quaternion_impl.h"
#include "reference/tiers_impl.h"
#include "reference/tumble_impl.h"

namespace touchstone::reference {

/// The exact start of a flight, and its constants.
struct Departure {
  mpq_class since;  ///< s
  Triple centre;    ///< of the reference point, in B
  Triple p, v, c;   ///< its place, velocity and acceleration, in W
  std::array<mpq_class, 4> q;
  mpq_class q_squared;             ///< |q|²
  Triple w;                        ///< in W
  Triple Omega, sigma;             ///< see above
  std::shared_ptr<const Tumble> tumble;  ///< if it does; Omega and sigma then say nothing
  bool pi = false;                 ///< a rational stands for π in centre and c
};

/// Requires a completed scene with a flight. Throws InputError if a push of the body begins after its start, and what
/// heavy() throws.
Departure departure(const Scene& scene, std::size_t body);

/// At one time; W's axes.
template <class E>
struct Flying {
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

/// A Departure with its constants enclosed. Every member function inside the tier's scope.
template <class Tier>
class Flyer {
 public:
  using E = typename Tier::E;
  using P = typename Tier::P;

  explicit Flyer(const Departure& departure);

  Flying<E> at(const E& time) const;

  const Coordinates<E>& centre() const { return centre_; }
  const Coordinates<E>& acceleration() const { return c_; }  ///< of the reference point

  /// ≥ |ω|² + |ω'| at all times: a point of the body at r from the reference point has an acceleration beyond the
  /// reference point's of at most this times |r|. Everything where nothing is known.
  const E& turning() const { return turning_; }

 private:
  E since_, q_squared_;
  Coordinates<E> centre_, p_, v_, c_;
  Rotor<E> q_;
  Spin<E> outer_, inner_;
  E turning_;
  std::shared_ptr<const Tumble> tumble_;
};

}  // namespace touchstone::reference
