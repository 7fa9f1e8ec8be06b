// Euler's equations for a body with three different moments of inertia, integrated step by step.
#pragma once

#include <array>
#include <vector>

#include "fast/motion/tumble_period.h"
#include "fast/rounding.h"
#include "model/frame.h"

namespace touchstone::fast::motion {

/// Torque-free rotation from time 0; P: the principal axes, P0: their orientation at time 0.
///
///   ω₁' = c₁ ω₂ ω₃, and cyclically (fast/motion/inertia.h);   q' = q ω/2, R_P0P = R(q).
///
/// Taylor series to order 20, in steps so short that the last two terms are below u/8. Steps are remembered, so that a
/// query costs one evaluation, some 0.1 µs, and a new step 3 µs. ω is periodic (tumble_period.h), and the body rotates
/// by the same rotation in every period: R(t + nT) = R(T)ⁿ R(t). So only the first period is integrated, and ω never
/// drifts.
///
/// Error, to first order: the error of ω grows by the linearised equations, δω' = A(ω) δω, and the error of the
/// rotation is its integral. δω is enclosed in the ellipsoid {δω: δωᵀ S⁻¹ δω ≤ 1}. A step's own matrix Φ (integrated
/// alongside by its series) maps S to Φ S Φᵀ; adding a ball of radius ε, the step's new error, gives an ellipsoid
/// within (1 + 1/k) S + (1 + k) ε² for any k: k is what makes the trace least, and at most 16, 17, ..., with which a
/// number N of equal errors adds up to no more than some N of them. So errors that the flow contracts are not counted
/// as if they grew, which makes all the difference near the middle axis. Early in a step less is claimed: with g the
/// greatest eigenvalue of the symmetric part of A along the motion, an error of ω grows by no more than a factor exp(g
/// τ), and that of the rotation by τ times the error of ω. For each of the two errors, an eighth more is claimed. n
/// periods add n times the error of one, and n times the effect of the period's error. Claims nothing (error 2) once
/// the error exceeds 2^-10, or if the period is unknown: the first 2^14 units of time are then repeated. |L| and the
/// energy are conserved in any case.
class Tumble {
 public:
  struct Now {
    Quaternion q_P0P;
    Vec3 w_P = Vec3::Zero();  ///< rad/s
    double error = 0;         ///< rad
    double w_error = 0;       ///< rad/s
    /// Error of this result relative to results for times shortly before or after.
    double computed_error = 0;    ///< rad
    double computed_w_error = 0;  ///< rad/s
  };

  Tumble() = default;
  /// `w_error`: relative to w_P.
  Tumble(const Vec3& c, double c_error, const Vec3& w_P, double w_error);

  /// Requires tau ≥ 0 (s).
  Now at(double tau);
  /// Whether the rotation at tau (s) follows the body's own at all: the period is known, or not over.
  bool follows(double tau) const;

 private:
  /// A choice: a step is as long as the series converges. A higher order makes longer steps and costs more for each.
  static constexpr int order = 20;
  using Terms = std::array<double, 7>;  ///< of q and ω

  /// In units of time in which Ω is about 1.
  struct Step {
    double from = 0;
    double length = 0;
    std::array<Terms, order + 1> series;  ///< in (time − from)/length
    double error_before = 0;              ///< at its start, as w_error_before
    double w_error_before = 0;
    double error = 0;  ///< at its end, and before
    double w_error = 0;
  };

  /// Of the motion.
  struct Greatest {
    double rate = 0;    ///< |ω|
    double growth = 0;  ///< the rate at which an error of ω grows
  };

  Now within(double time);  ///< in the first period
  Quaternion turn_in(double periods);
  Step step(double from, const Terms& start);
  void grow_errors(Step& taken);
  double new_error(double time) const;
  double w_error_after(const Step& step, double time) const;
  double turn_error_after(const Step& step, double time) const;
  static Terms sum(const Step& step, double x);

  std::vector<Step> steps_;
  Vec3 c_ = Vec3::Zero();
  double c_error_ = 0;
  Greatest greatest_;
  Terms start_{};
  double scale_ = 1;            ///< 1/s: the unit of rates
  Mat3 spread_ = Mat3::Zero();  ///< S, the ellipsoid of ω's error
  double error_ = 0;
  Period period_;
  std::vector<Quaternion> turns_;  ///< by 1, 2, 4, ... periods
  double turn_error_ = 0;          ///< of one period's rotation
  double jump_ = 0;                ///< of ω between the end of a period and its start
};

}  // namespace touchstone::fast::motion
