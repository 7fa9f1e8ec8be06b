// The impulse of a contact that rests: many small impacts in place of a force.
#pragma once

#include "fast/impulse/solve.h"

namespace touchstone::fast::impulse {

/// If P = −2 K⁻¹u is in the friction cone, it: u turns round, ΔT = (u + u_f)·P/2 = 0, and over many such impacts a body
/// that friction holds goes nowhere, as it goes back as far as it went. Else the body slips: the impact with e = 1 and
/// Poisson's law, whose friction loses what sliding loses.
///
/// Only c = 2 in P = −c K⁻¹u keeps the energy, which changes by the factor (1 − c)². Source: Mirtich 1996, 3.5;
/// docs/design/impulse.md.
Outcome micro_collision(Impact impact);

}  // namespace touchstone::fast::impulse
