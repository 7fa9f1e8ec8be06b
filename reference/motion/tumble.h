// Free rotation with three different moments of inertia, in closed form: as exact after 10,000 radians as after one.
//
//   I ω' = (I ω) × ω,   q' = ½ q ∘ (0, ω),   ω and I in the body's axes.
//
// P are principal axes: the third is the one about which the angular momentum L circulates, the second belongs to the
// middle moment, and the directions are such that ω_1, ω_3 ≥ 0 at τ = 0. With c_1 = (I_2 − I_3)/I_1 and so on
// cyclically (c_1 and c_3 have one sign, c_2 has the other), A = |c_2| ω_1² + |c_1| ω_2² and D = |c_3| ω_2² + |c_2|
// ω_3² (constants), λ² = |c_1| D, k² = |c_3| A/λ²,
//   ω_1 = W_1 cn s,  ω_2 = W_2 sn s,  ω_3 = W_3 dn s,   s = s_0 + λ τ,
//   W_1² = A/|c_2|,  W_3² = D/|c_2|,  W_2 = c_2 W_1 W_3/λ.
// (Jacobi.) With N an inertial frame whose third axis is along L, and l = L_P/|L|,
//   q_NP = exp(e_3 ψ/2) ∘ p,   p = (1 + l_3, l × e_3)/√(2 (1 + l_3)),
// where p is the least rotation that takes l to e_3. So ω·(l + e_3) = ψ' (1 + l_3), and with twice the energy 2T = ω·L
//   ψ' = (2T + |L| ω_3)/(|L| + I_3 ω_3).
// As a function of s it has simple poles where dn s = −|L|/(I_3 W_3), with residue ±i for τ. So exp(iψ) is a quotient
// of theta functions (Jacobi; Klein and Sommerfeld),
//   ψ = μ τ + 2 σ arg θ_4(v + iδ, q²),   v = π s/(2K),  q = exp(−π K'/K),  δ = π η/(2K),
// with dn(η, k')/cn(η, k') = |L|/(I_3 W_3), and σ = −1 if I_3 is the greatest moment, 1 if it is the least; ψ' at s = 0
// gives μ. If L² = 2T I_2 exactly, then k = 1, ω_1 = W_1/cosh s and so on, and
//   ψ = |L|/I_2 τ + 2 σ arg (1 + i tan(χ/2) tanh(s/2)),   cos χ = I_3 W_3/|L|.
#pragma once

#include <gmpxx.h>

#include <array>
#include <vector>

#include "reference/exact/linear.h"
#include "reference/exact/quaternion.h"
#include "reference/exact/tiers.h"
#include "reference/motion/principal_axes.h"

namespace touchstone::reference {

class Tumble {
 public:
  /// Starts at τ = 0 with attitude q (of any length) and angular velocity w_B, not about a principal axis. Where 76
  /// digits hardly distinguish the motion from one about an axis (some 2^-100), it is one about this axis up to an
  /// error that grows exponentially with time, and nothing is known once it is beyond 2^-64; nor is anything known
  /// where they hardly distinguish it from another one with k = 1.
  Tumble(const Square<mpq_class>& I_B, const std::array<mpq_class, 4>& q, const Three<mpq_class>& w_B);

  template <class E>
  struct At {
    Rotor<E> q;  ///< of the same length as the initial q
    Coordinates<E> w_B;
  };
  At<Enclosure> at(const Enclosure& tau) const;  ///< inside RoundUpward; infinite intervals where nothing is known
  At<WideEnclosure> at(const WideEnclosure& tau) const;

  /// ≥ |ω|² + |ω'|, at all times.
  const WideEnclosure& turning() const { return turning_; }

 private:
  /// The coefficients of the waves of m v: 2 q^(m²/4), odd m for θ_2 and even m for θ_3; the same with the signs of θ_1
  /// and θ_4; and, for even m, those of the real and the imaginary part of θ_4(v + iδ, q²).
  template <class E>
  struct Weight {
    E plain, alternating, real, imaginary;
  };

  /// The constants of the motion.
  template <class E>
  struct Constants {
    bool known = false;
    bool returns = true;                 ///< k < 1
    E phase, rate;                       ///< phase and rate of v; of s if k = 1
    E spin;                              ///< μ/2
    Coordinates<E> W;                    ///< times the constant factors of the quotients of theta functions
    Coordinates<E> share;                ///< I/|L|
    std::vector<Weight<E>> series;       ///< for m = 1, 2, ...
    E lean;                              ///< σ; if k = 1, σ tan(χ/2)
    std::array<Coordinates<E>, 3> axes;  ///< axes of P in B
    Rotor<E> q;                          ///< q_WB at τ = 0
    Rotor<E> back;                       ///< q_PN at τ = 0
  };

  /// A motion near a rotation about an axis (tumble.cpp).
  template <class E>
  struct NearAxis {
    Rotor<E> q;              ///< q_WB at τ = 0
    Coordinates<E> axis;     ///< e, in B
    E rate;                  ///< ω_0
    E off, growth, unequal;  ///< |δ_0|, κ Ω and κ
  };

  /// cn s, sn s and dn s, each up to a constant, and a number whose argument is σ arg θ_4.
  template <class E>
  struct Wave {
    E cn, sn, dn, real, imaginary;
  };

  struct Invariants;
  void set_tumble(const Square<mpq_class>& I_B, const Three<mpq_class>& w_B, const PrincipalAxes& found);
  void set_near_axis(const Coordinates<WideEnclosure>& w, const PrincipalAxes& found);
  void set_waves(const Invariants& of);
  void set_last_wave(const Invariants& of);
  template <class E>
  static Wave<E> wave(const Constants<E>& constants, const E& tau);
  template <class E>
  static Wave<E> last_wave(const Constants<E>& constants, const E& tau);
  template <class E>
  static At<E> in_P(const Constants<E>& constants, const E& tau);
  template <class E>
  static At<E> at(const NearAxis<E>& near, const E& tau);
  template <class E>
  static At<E> at(const Constants<E>& constants, const E& tau);

  Constants<WideEnclosure> wide_;
  Constants<Enclosure> narrow_;
  NearAxis<WideEnclosure> wide_near_;  ///< in place of these, where they are not known
  NearAxis<Enclosure> narrow_near_;
  WideEnclosure turning_;
};

}  // namespace touchstone::reference
