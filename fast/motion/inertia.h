// The principal axes of a body and the coefficients of its Euler equations.
#pragma once

#include "model/scene.h"

namespace touchstone::fast::motion {

/// Euler's equations without torque, in principal axes P: ω₁' = c₁ ω₂ ω₃ with c₁ = (I₂ − I₃)/I₁, and cyclically. The
/// moments enter through c alone.
struct Inertia {
  Quaternion q_BP;
  Vec3 c = Vec3::Zero();
  /// The exact ω' differs from that of the computed axes and coefficients by at most c_error |ω|². 0 only if both are
  /// exact.
  double c_error = 0;
  /// P is B, and coefficients are exactly 0 where moments are equal.
  bool is_aligned = true;
};

/// For a body that is not fixed. With a density, moments come from C = ∫ (x − c)(x − c)ᵀ dV (I₂ − I₃ = C₃₃ − C₂₂, so
/// that the difference keeps its digits for a needle): exact for a polytope, so that equal moments are known to be
/// equal; closed forms for sphere and box; exact or with some 200 bits for a compound (spread.h).
///
/// c_error: P is chosen in doubles and then taken as exact; the off-diagonal entries of I in P, and c itself, are
/// computed without rounding. An error δI of I changes ω' = I⁻¹(Iω × ω) by at most 3 ‖δI‖/I_min |ω|². Here ‖δI‖ is
/// twice the sum of the off-diagonal entries, and for an error e of each entry of a compound's C ‖δI‖ ≤ (1 + √3) 3e. If
/// aligned: 5u relative to each c. Throws InputError for a polytope without faces.
Inertia inertia(const Body& body);

}  // namespace touchstone::fast::motion
