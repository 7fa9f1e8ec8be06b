// Euler's equations of a body with three different moments of inertia, step by step.
#pragma once

#include <array>
#include <vector>

#include "model/frame.h"

namespace touchstone::fast::motion {

/// Free turning from rest at time 0: P the principal axes, P0 where they stood at first.
///
///   ω₁' = c₁ ω₂ ω₃, c₁ = (I₂ − I₃)/I₁, and so on in turn;   q' = q ω/2, R_P0P = R(q).
///
/// Taylor series of order 20 in steps that leave out less than a rounding unit; what is taken is remembered, so that a
/// time costs one evaluation. After each step ω is put back onto the ellipsoids of T and L, and q has length 1: energy
/// and momentum stay as they were, to rounding, for ever.
///
/// Error: an error of ω at one time grows as the linearised equations say, δω' = A(ω) δω; the turn is off by its
/// integral. Both are followed along (docs/design/time_of_impact.md).
class Tumble {
 public:
  struct Now {
    Quaternion q_P0P;  ///< of length 1 within rounding
    Vec3 w_P0P_P;      ///< rad/s
    double error = 0;  ///< rad; the turn's distance from the exact one
  };

  Tumble() = default;
  /// `moment_error`: relative, of each moment; `rate_error`: relative, of ω.
  Tumble(const Vec3& moments, const Vec3& w_P0P_P, double moment_error, double rate_error);

  /// Requires tau ≥ 0 (s).
  Now at(double tau);

  static constexpr int order = 20;

 private:
  struct Step {
    double from = 0;
    double error = 0;                                     ///< at its end
    std::array<std::array<double, 7>, order + 1> series;  ///< of q and ω, scaled to the step's length
  };

  void go_on();

  std::vector<Step> steps_;
  Vec3 c_ = Vec3::Zero();
};

}  // namespace touchstone::fast::motion
