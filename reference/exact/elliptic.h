// Elliptic integrals of the first kind, enclosed.
#pragma once

#include "reference/exact/tiers.h"

namespace touchstone::reference {

/// Carlson's R_F(x, y, z) = ½ ∫₀^∞ dt / √((t + x)(t + y)(t + z)). Requires numbers ≥ 0, at most one of them 0; the part
/// of an interval below 0 is ignored.
///
/// By duplication: with λ = √(xy) + √(yz) + √(zx), R_F(x, y, z) = R_F((x + λ)/4, (y + λ)/4, (z + λ)/4), and the three
/// arguments converge to each other. With the arithmetic mean A, the geometric mean G and the harmonic mean H, (t + H)³
/// ≤ (t + G)³ ≤ (t + x)(t + y)(t + z) ≤ (t + A)³ (Hölder; arithmetic and geometric means). So 1/√A ≤ R_F ≤ 1/√H: bounds
/// that differ by the square of the remaining difference of the three arguments. (Carlson 1995.)
WideEnclosure first_kind(WideEnclosure x, WideEnclosure y, WideEnclosure z);

}  // namespace touchstone::reference
