// The period of a torque-free body's angular velocity in its own axes.
#pragma once

#include "model/frame.h"

namespace touchstone::fast::motion {

struct Period {
  double length = 0;
  double error = 0;  ///< infinite: the period is unknown
};

/// The period of ω under ω₁' = c₁ ω₂ ω₃ and cyclically (fast/motion/inertia.h). Let axis 2 be the middle one (c₂ has
/// the opposite sign, and no lesser magnitude: |c₂| = (|c₁| + |c₃|)/(1 + |c₁c₃|)). Then A = |c₂|ω₁² + |c₁|ω₂² and D
/// = |c₃|ω₂² + |c₂|ω₃² are constant, ω₂'² = (A − |c₁|ω₂²)(D − |c₃|ω₂²), and ω₂ oscillates with the period
///
///   T = 4K(k)/λ = 2π/agm(x, y),   x² = λ² = max(|c₁|D, |c₃|A),   y² = λ²(1 − k²) = |c₂| | |c₁|ω₃² − |c₃|ω₁² |,
///
/// where agm is the arithmetic-geometric mean: only + × ÷ and sqrt, some five times (Gauss). The period is unknown
/// where y or x is nothing but rounding (on the way to the middle axis, and for bodies that are nearly round), and
/// where it would be longer than 2^14 (in w's unit).
///
/// Error, to first order, with half as much again claimed. `w_error`: relative to w. An error δI of the inertia changes
/// c by c_error, and axis k by δI_ij/(I_i − I_j): times its factor |c₁| or |c₃|, c_error again. So the error of x² is
/// (8 c_error + 4 w_error + 8u)|ω|², and that of y² as much times |ω_⊥|/|ω|, where ω_⊥ is ω without its middle
/// component. The mean is homogeneous of degree 1 and increases with both arguments, with the lesser one by at most
/// half of the degree; it rounds by 32u.
Period period(const Vec3& c, double c_error, const Vec3& w, double w_error);

}  // namespace touchstone::fast::motion
