// Free rotation with three different moments of inertia: Euler's equations, enclosed by Taylor series.
//
//   ω' = I⁻¹ ((I ω) × ω),   q' = ½ q ∘ (0, ω),   ω and I in the body's axes.
// A step has a box that holds the solution throughout (if y(τ) + [0, h] f(box) is within the box, Picard's iteration
// stays there), and from it the remainder of the series of degree N: its coefficient N, taken over the box (Lagrange).
// Each order adds some 3.5 bits less than the one before, so the first `wide_orders` coefficients have 76 digits and
// the rest, like the remainder, are doubles. Plain intervals, no wrapping control: the digits outlast the growth
// (Moore, Kearfott and Cloud, Introduction to Interval Analysis).
#pragma once

#include <gmpxx.h>

#include <array>
#include <optional>
#include <vector>

#include "reference/quaternion_impl.h"
#include "reference/tiers_impl.h"

namespace touchstone::reference {

class Tumble {
 public:
  /// From attitude q (any length) and angular velocity w_B, at τ = 0.
  Tumble(const std::array<std::array<mpq_class, 3>, 3>& I_B, const std::array<mpq_class, 4>& q,
         const std::array<mpq_class, 3>& w_B);

  template <class E>
  struct At {
    Rotor<E> q;  ///< of the length of the first one
    Coordinates<E> w_B;
  };
  At<Enclosure> at(const Enclosure& tau);  ///< inside RoundUpward; everything, where nothing is known
  At<WideEnclosure> at(const WideEnclosure& tau);

  /// |ω|² + |ω'| from τ until some time in the next step.
  struct Bound {
    WideEnclosure turning;
    Float until;  ///< τ itself where nothing is known
  };
  Bound bound(const Float& tau);

 private:
  static constexpr std::size_t degree = 30, wide_orders = 14;
  static constexpr std::size_t most_steps = 1000;  ///< some seconds
  using State = std::array<WideEnclosure, 7>;      ///< q, ω
  template <class E>
  using Series = std::array<std::array<E, 7>, degree + 1>;

  /// Σ coefficient[k] s^k holds the state at begin + s, 0 ≤ s ≤ validated; the last coefficient holds the remainder.
  struct Step {
    Float begin, validated;
    Series<WideEnclosure> wide;
    Series<Enclosure> narrow;
    WideEnclosure turning;

    Float end() const { return begin + validated * Float(1 - 0x1p-20); }  ///< leaves room for a τ that is not thin
  };

  template <class E>
  struct Equations {
    std::array<Coordinates<E>, 3> I, I_inverse;

    std::array<E, 7> derivative(const std::array<E, 7>& y) const;
    void extend(Series<E>& c, std::size_t from,
                std::size_t to) const;  ///< orders up to `to`; those up to `from` are there
  };

  static Float stride(const Series<Enclosure>& c);
  std::optional<State> tube(const State& y, const Float& h) const;
  bool is_lost() const;
  bool extend();                          ///< by a step; false if there is none
  const Step* step_at(const Float& tau);  ///< none beyond the last
  template <class E>
  At<E> sum(const E& tau, Series<E> Step::*series);

  Equations<WideEnclosure> wide_;
  Equations<Enclosure> narrow_;  ///< the same for doubles; inside RoundUpward
  State now_;
  std::vector<Step> steps_;
};

}  // namespace touchstone::reference
