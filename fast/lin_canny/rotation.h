// R(q/|q|) in doubles, with a bound on its distance from the exact rotation.
#pragma once

#include "fast/rounding.h"
#include "model/frame.h"

namespace touchstone::fast::lin_canny {

/// R with ‖R − R(q/|q|)‖₂ ≤ 12u, for any q ≠ 0.
///
/// Each entry is N s, with N a difference of products and s ≈ 1/D, D = |q|².
///   D = (w² + x²) + (y² + z²), all terms ≥ 0: relative 3u; 1/D: 1u more. One factor for all entries, ‖R‖₂ = 1: 4u.
///   The product N s: u|R_ij| each, ‖R‖_F = √3: < 1.8u.
///   N off the diagonal, 2(xy ± wz): products u each, the difference u|N|: ≤ 2u(|xy| + |wz|) + u|N|, and
///   (|xy| + |wz|)² ≤ (x² + w²)(y² + z²) ≤ D²/4, so uD + u|N|.
///   N on the diagonal, (w² + x²) − (y² + z²) and so on: squares uD together, sums uD, the difference u|N|.
///   Frobenius norm of six uD and three 2uD: √18 uD < 4.3uD; the u|N|: another 1.8u.
/// Together < 11.9u; 12u covers the terms of second order. q is scaled by a power of two so that nothing overflows;
/// underflow then costs less than 2^-900.
Mat3 rotation(const Quaternion& q);

/// The same rotation by a quaternion whose squares neither overflow nor underflow: q itself, or q times a power of two.
Quaternion at_moderate_scale(const Quaternion& q);

/// A computed R v: three products and two sums a row, rows of length 1: √3·3u|v| < 5.2u|v|. With the rotation's own
/// error |computed − R(q/|q|) v| ≤ turn_error |v|; the same for Rᵀ.
constexpr double turn_error = 18 * u;

}  // namespace touchstone::fast::lin_canny
