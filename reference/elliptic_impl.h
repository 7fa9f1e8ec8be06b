// Elliptic integrals of the first kind, enclosed.
#pragma once

#include "reference/tiers_impl.h"

namespace touchstone::reference {

/// Carlson's R_F(x, y, z) = ½ ∫₀^∞ dt / √((t + x)(t + y)(t + z)), for numbers ≥ 0 of which one at most is 0. What of an
/// interval is below 0 is left out.
///
/// By duplication: with λ = √(xy) + √(yz) + √(zx), R_F(x, y, z) = R_F((x + λ)/4, (y + λ)/4, (z + λ)/4), and so the
/// three come to each other. For the arithmetic mean A, the geometric mean G and the harmonic mean H, (t + H)³ ≤ (t +
/// G)³ ≤ (t + x)(t + y)(t + z) ≤ (t + A)³ (Hölder; arithmetic and geometric means), so 1/√A ≤ R_F ≤ 1/√H: ends that
/// differ by the square of what is left between the three. (Carlson 1995.)
WideEnclosure first_kind(WideEnclosure x, WideEnclosure y, WideEnclosure z);

}  // namespace touchstone::reference
