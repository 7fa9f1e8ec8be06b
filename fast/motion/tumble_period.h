// After what time a freely turning body's angular velocity comes back.
#pragma once

#include "model/frame.h"

namespace touchstone::fast::motion {

struct Period {
  double length = 0;
  double error = 0;  ///< infinite: not known
};

/// Of ω' with ω₁' = c₁ ω₂ ω₃ and so on in turn (fast/motion/inertia.h). Axis 2 being the middle one (c₂ has the other
/// sign, and is the greatest: |c₂| = (|c₁| + |c₃|)/(1 + |c₁c₃|)), A = |c₂|ω₁² + |c₁|ω₂² and D = |c₃|ω₂² + |c₂|ω₃² stay,
/// ω₂'² = (A − |c₁|ω₂²)(D − |c₃|ω₂²), and ω₂ goes to and fro in
///
///   T = 4K(k)/λ = 2π/agm(x, y),   x² = λ² = max(|c₁|D, |c₃|A),   y² = λ²(1 − k²) = |c₂| | |c₁|ω₃² − |c₃|ω₁² |,
///
/// agm the arithmetic-geometric mean: only + × ÷ and sqrt, some five times (Gauss). Where y or x is nothing but
/// rounding, on the way to the middle axis and for bodies that are nearly round, there is no telling; nor is a period
/// known that would be longer than 2^14 (in w's unit).
///
/// Error, to first order, with half as much again claimed. `w_error`: relative, of w. With inertia up to δI, c changes
/// by c_error, and axis k by δI_ij/(I_i − I_j): times what multiplies it, |c₁| or |c₃|, c_error again. So x² is off by
/// (8 c_error + 4 w_error + 8u)|ω|², y² by as much times |ω_⊥|/|ω|, ω_⊥ without the middle axis. The mean is of degree
/// 1, and rises with both, with the lesser by half of the degree at most; it rounds by 32u.
Period period(const Vec3& c, double c_error, const Vec3& w, double w_error);

}  // namespace touchstone::fast::motion
