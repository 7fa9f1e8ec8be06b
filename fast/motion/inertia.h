// The axes about which a body turns, and how its turns feed each other.
#pragma once

#include "model/scene.h"

namespace touchstone::fast::motion {

/// Euler's equations without a torque, in principal axes P: ω₁' = c₁ ω₂ ω₃ with c₁ = (I₂ − I₃)/I₁, and so on in turn.
/// Moments enter through c alone.
struct Inertia {
  Quaternion q_BP;
  Vec3 c = Vec3::Zero();
  /// The exact ω' is the computed axes' and coefficients', give or take c_error |ω|². 0 only if both are exact zeros.
  double c_error = 0;
  /// P is B, and coefficients are 0 exactly where moments are equal.
  bool is_aligned = true;
};

/// Of a body that is not fixed. Moments of a density come from C = ∫ (x − c)(x − c)ᵀ dV (I₂ − I₃ = C₃₃ − C₂₂, so that a
/// needle's difference keeps its digits): exact sums for a polytope, rounded once; closed forms for sphere and box.
///
/// c_error: P is chosen in doubles and taken as exact; what of I is off the diagonal there, and c itself, are found
/// without rounding. With I up to δI, ω' = I⁻¹(Iω × ω) is up to 3 ‖δI‖/I_min |ω|²: twice what is off the diagonal, and
/// for C up to e (the double entries of a density's C, 6u each) ‖δI‖ ≤ (1 + √3) e. Aligned: relative 5u of each c.
/// Throws InputError for a polytope without faces.
Inertia inertia(const Body& body);

}  // namespace touchstone::fast::motion
