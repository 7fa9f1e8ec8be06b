// Euler's equations of a body with three different moments of inertia, step by step.
#pragma once

#include <array>
#include <vector>

#include "model/frame.h"

namespace touchstone::fast::motion {

/// Free turning from time 0: P the principal axes, P0 where they stood at first.
///
///   ω₁' = c₁ ω₂ ω₃, and so on in turn (fast/motion/inertia.h);   q' = q ω/2, R_P0P = R(q).
///
/// Taylor series to order 20 in steps so short that the last two terms are below u/8; steps are remembered, so that a
/// time costs one evaluation, some 0.1 µs, and a step 3 µs.
///
/// Error, to first order: what ω is off grows as the linearised equations say, δω' = A(ω) δω, and the turn is off by
/// its integral. With Ψ(t) their fundamental matrix (Ψ(0) = 1, followed along by its own series) and ε_k what is new in
/// step k, |δω(t)| ≤ ‖Ψ(t)‖ Σ_k ‖Ψ(t_k)⁻¹‖ ε_k: it grows with time, not exponentially, as phases do. Half as much
/// again, for each of the two factors, is claimed. Claims nothing (error 2) once it is beyond 2^-10, or after 2^13
/// steps.
class Tumble {
 public:
  struct Now {
    Quaternion q_P0P;
    Vec3 w_P = Vec3::Zero();  ///< rad/s
    double error = 0;         ///< rad
    double w_error = 0;       ///< rad/s
  };

  Tumble() = default;
  /// `w_error`: relative, of w_P.
  Tumble(const Vec3& c, double c_error, const Vec3& w_P, double w_error);

  /// Requires tau ≥ 0 (s).
  Now at(double tau);

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

  Step step(double from, const Terms& start);
  void grow_errors(Step& taken);
  static Terms sum(const Step& step, double x);

  std::vector<Step> steps_;
  Vec3 c_ = Vec3::Zero();
  double c_error_ = 0;
  Terms start_{};
  double scale_ = 1;                        ///< 1/s: the unit of rates
  Mat3 growth_ = Mat3::Identity();          ///< Ψ
  Mat3 inverse_growth_ = Mat3::Identity();  ///< Ψ⁻¹
  double injected_ = 0;                     ///< Σ ‖Ψ⁻¹‖ ε
  double error_ = 0;
};

}  // namespace touchstone::fast::motion
