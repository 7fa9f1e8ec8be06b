// The capsule about the long axis of a body that spins about it.
#pragma once

#include <array>
#include <optional>

#include "fast/time_of_impact/moving_core.h"

namespace touchstone::fast::time_of_impact {

/// Bounds, at all times, on the motion of a point at a distance of 1 m on the principal axis e of a torque-free body.
struct AxisMotion {
  double acceleration = 0;  ///< m/s²
  double jerk = 0;          ///< m/s³
};

/// e is principal axis `axis`, which is not the middle one, and ω the angular velocity at some time, both in principal
/// axes; `w_error` bounds the error of ω. With e first, ω⊥² = ω₂² + ω₃², and Euler's ω_i' = c_i ω_j ω_k:
///
///   ė = (0, ω₃, −ω₂)
///   ë = (−ω⊥², (1 + c₃) ω₁ω₂, (1 − c₂) ω₁ω₃)
///   |e⃛| ≤ |c₂ + c₃| Ω ω⊥² + ω⊥³ + κ (|c₁| ω⊥³ + (|c₂| + |c₃| + 2) Ω² ω⊥),   κ = max(|1 + c₃|, |1 − c₂|)
///
/// ω₂²/c₂ − ω₃²/c₃ is constant, so ω⊥² ≤ max(|c₂|, |c₃|) (ω₂²/|c₂| + ω₃²/|c₃|) at all times. Of a needle c₂ and −c₃ are
/// nearly 1, and κ is nearly 0: its axis turns slowly, however fast it spins about it. Axes and coefficients that are
/// off by c_error turn e by as much, and change ω' by c_error Ω². None for a middle axis, or unless |c₂|, |c₃| > 1/2.
std::optional<AxisMotion> axis_motion(const motion::Inertia& inertia, int axis, const Vec3& w_P, double w_error,
                                      double rate);

/// The balls at the two ends of a capsule that contains part `part` of the moving body, of which `side` is the moving
/// core; each moves with the end of the body's axis. A plane of constant direction separates the capsule if it
/// separates both. None if the body is not thin, or does not turn about its long axis mainly.
std::optional<std::array<MovingCore, 2>> capsule_about(const motion::BallisticMotion& motion, std::size_t part,
                                                       const MovingCore& side);

}  // namespace touchstone::fast::time_of_impact
