// The impulse of a resting contact: many small impacts in place of a force.
#pragma once

#include "fast/impulse/solve.h"

namespace touchstone::fast::impulse {

/// P = −2 K⁻¹u if that is in the friction cone: u is reversed, ΔT = (u + u_f)·P/2 = 0, and over many such impacts a
/// body held by friction stays in place, as it moves back as far as it moved. Otherwise the body slips: the impact with
/// e = 1 and Poisson's law, whose friction dissipates as sliding does.
///
/// Only c = 2 in P = −c K⁻¹u conserves the energy, which changes by the factor (1 − c)². Source: Mirtich 1996, 3.5;
/// docs/design/impulse.md.
Outcome micro_collision(Impact impact);

}  // namespace touchstone::fast::impulse
