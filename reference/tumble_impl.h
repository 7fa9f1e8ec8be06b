// Free rotation with three different moments of inertia, in closed form: as exact after 10,000 radians as after one.
//
//   I ω' = (I ω) × ω,   q' = ½ q ∘ (0, ω),   ω and I in the body's axes.
//
// In principal axes P, the third the one about which the angular momentum L goes round, the second the middle one, both
// in the direction in which ω_1, ω_3 ≥ 0 at first: with c_1 = (I_2 − I_3)/I_1 and so on in turn (c_1 and c_3 have one
// sign, c_2 has the other), A = |c_2| ω_1² + |c_1| ω_2² and D = |c_3| ω_2² + |c_2| ω_3² (constants), λ² = |c_1| D,
// k² = |c_3| A/λ²,
//   ω_1 = W_1 cn s,  ω_2 = W_2 sn s,  ω_3 = W_3 dn s,   s = s_0 + λ τ,
//   W_1² = A/|c_2|,  W_3² = D/|c_2|,  W_2 = c_2 W_1 W_3/λ.
// (Jacobi.) With N an inertial frame whose third axis is along L, and l = L_P/|L|,
//   q_NP = exp(e_3 ψ/2) ∘ p,   p = (1 + l_3, l × e_3)/√(2 (1 + l_3)),
// p being the least rotation that takes l to e_3; so ω·(l + e_3) = ψ' (1 + l_3), and with twice the energy 2T = ω·L
//   ψ' = (2T + |L| ω_3)/(|L| + I_3 ω_3).
// As a function of s it has simple poles, where dn s = −|L|/(I_3 W_3), of residue ±i for τ: so exp(iψ) is a quotient of
// theta functions (Jacobi; Klein and Sommerfeld),
//   ψ = μ τ + 2 σ arg θ_4(v + iδ, q²),   v = π s/(2K),  q = exp(−π K'/K),  δ = π η/(2K),
// with dn(η, k')/cn(η, k') = |L|/(I_3 W_3), σ = −1 where I_3 is the greatest moment and 1 where it is the least; μ from
// ψ' at s = 0. If L² = 2T I_2 exactly, k = 1: ω_1 = W_1/cosh s and so on, and
//   ψ = |L|/I_2 τ + 2 σ arg (1 + i tan(χ/2) tanh(s/2)),   cos χ = I_3 W_3/|L|.
#pragma once

#include <gmpxx.h>

#include <array>
#include <vector>

#include "reference/linear_impl.h"
#include "reference/quaternion_impl.h"
#include "reference/tiers_impl.h"

namespace touchstone::reference {

class Tumble {
 public:
  /// From attitude q (any length) and angular velocity w_B, not about a principal axis, at τ = 0. Nothing is known
  /// where 76 digits hardly tell the motion from one about an axis, or from one with k = 1 (some 2^-100).
  Tumble(const Square<mpq_class>& I_B, const std::array<mpq_class, 4>& q, const Three<mpq_class>& w_B);

  template <class E>
  struct At {
    Rotor<E> q;  ///< of the length of the first one
    Coordinates<E> w_B;
  };
  At<Enclosure> at(const Enclosure& tau) const;  ///< inside RoundUpward; everything, where nothing is known
  At<WideEnclosure> at(const WideEnclosure& tau) const;

  /// ≥ |ω|² + |ω'|, at all times.
  const WideEnclosure& turning() const { return turning_; }

 private:
  /// Of m v: 2 q^(m²/4), odd m of θ_2 and even m of θ_3; with the signs of θ_1 and θ_4; and, for even m, of the real
  /// and the imaginary part of θ_4(v + iδ, q²).
  template <class E>
  struct Weight {
    E plain, alternating, real, imaginary;
  };

  /// The constants of the motion.
  template <class E>
  struct Course {
    bool known = false;
    bool returns = true;                 ///< k < 1
    E phase, rate;                       ///< of v; of s where k = 1
    E spin;                              ///< μ/2
    Coordinates<E> W;                    ///< times what the quotients of theta functions lack
    Coordinates<E> share;                ///< I/|L|
    std::vector<Weight<E>> series;       ///< of m = 1, 2, ...
    E lean;                              ///< σ; where k = 1, σ tan(χ/2)
    std::array<Coordinates<E>, 3> axes;  ///< of P in B
    Rotor<E> q;                          ///< q_WB at first
    Rotor<E> back;                       ///< q_PN at first
  };

  /// cn s, sn s, dn s, each up to a constant; and a number whose argument is σ arg θ_4.
  template <class E>
  struct Wave {
    E cn, sn, dn, real, imaginary;
  };

  struct Invariants;
  void set_waves(const Invariants& of);
  void set_last_wave(const Invariants& of);
  template <class E>
  static Wave<E> wave(const Course<E>& course, const E& tau);
  template <class E>
  static Wave<E> last_wave(const Course<E>& course, const E& tau);
  template <class E>
  static At<E> in_P(const Course<E>& course, const E& tau);
  template <class E>
  static At<E> at(const Course<E>& course, const E& tau);

  Course<WideEnclosure> wide_;
  Course<Enclosure> narrow_;
  WideEnclosure turning_;
};

}  // namespace touchstone::reference
