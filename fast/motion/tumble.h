// Euler's equations of a body with three different moments of inertia, step by step.
#pragma once

#include <array>
#include <vector>

#include "fast/motion/tumble_period.h"
#include "fast/rounding.h"
#include "model/frame.h"

namespace touchstone::fast::motion {

/// Free turning from time 0: P the principal axes, P0 where they stood at first.
///
///   ω₁' = c₁ ω₂ ω₃, and so on in turn (fast/motion/inertia.h);   q' = q ω/2, R_P0P = R(q).
///
/// Taylor series to order 20 in steps so short that the last two terms are below u/8; steps are remembered, so that a
/// time costs one evaluation, some 0.1 µs, and a step 3 µs. ω comes back after a period (tumble_period.h), and what the
/// body turned by in one, it turns by in each: R(t + nT) = R(T)ⁿ R(t). So only the first period has steps, and ω never
/// drifts.
///
/// Error, to first order: what ω is off grows as the linearised equations say, δω' = A(ω) δω, and the turn is off by
/// its integral. An ellipsoid holds δω: {δω: δωᵀ S⁻¹ δω ≤ 1}. A step's own matrix Φ (followed along by its series)
/// makes Φ S Φᵀ of S; with a ball of radius ε, what is new in it, that is within (1 + 1/k) S + (1 + k) ε² for any k,
/// and k = 16, 17, ... takes N equal ones for no more than some N of them. So what the flow draws together does not
/// count as if it spread: near the middle axis that is all the difference. Half as much again, for each of the two, is
/// claimed. n periods add n times what one has, and n times what the period is off by. Claims nothing (error 2) once it
/// is beyond 2^-10, or where the period is not known: the first 2^14 units of time are followed then, again and again.
/// |L| and the energy are kept in any case.
class Tumble {
 public:
  struct Now {
    Quaternion q_P0P;
    Vec3 w_P = Vec3::Zero();  ///< rad/s
    double error = 0;         ///< rad
    double w_error = 0;       ///< rad/s
    /// Of what is said now against what is said a moment before or after it.
    double said_error = 0;    ///< rad
    double said_w_error = 0;  ///< rad/s
  };

  Tumble() = default;
  /// `w_error`: relative, of w_P.
  Tumble(const Vec3& c, double c_error, const Vec3& w_P, double w_error);

  /// Requires tau ≥ 0 (s).
  Now at(double tau);
  /// Whether what is said at tau (s) is the body's own turning at all: the period is known, or not over.
  bool follows(double tau) const;

 private:
  static constexpr int order = 20;
  using Terms = std::array<double, 7>;  ///< of q and ω

  /// In units in which Ω is about 1.
  struct Step {
    double from = 0;
    double length = 0;
    std::array<Terms, order + 1> series;  ///< in (time − from)/length
    double error = 0;                     ///< at its end, and before
    double w_error = 0;
  };

  Now within(double time);  ///< the first period
  Quaternion turn_in(double periods);
  Step step(double from, const Terms& start);
  void grow_errors(Step& taken);
  static Terms sum(const Step& step, double x);

  std::vector<Step> steps_;
  Vec3 c_ = Vec3::Zero();
  double c_error_ = 0;
  Terms start_{};
  double scale_ = 1;            ///< 1/s: the unit of rates
  Mat3 spread_ = Mat3::Zero();  ///< S
  double error_ = 0;
  Period period_;
  std::vector<Quaternion> turns_;  ///< in 1, 2, 4, ... periods
  double turn_error_ = 0;          ///< in one
  double jump_ = 0;                ///< of ω as the next begins
};

}  // namespace touchstone::fast::motion
