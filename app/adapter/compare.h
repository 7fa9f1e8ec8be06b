// Compares answers as generously as an engine's own errors need, but no more than a mistake of an adapter would hide.
#pragma once

#include <string>

#include "app/adapter/paper/paper_scene.h"

namespace touchstone::app {

/// What is wrong with an answer: empty if nothing is. A part that either answer lacks is not compared. Lengths may be
/// off by 0.01 m and a thousandth; masses, centres and inertias by a thousandth; directions by 0.1; velocities by a
/// hundredth, and at least 0.02; rotations by 0.02. The states of a motion may be off by what a stepper of first order
/// with steps of 1/60 s under 8 m/s² explains: 0.1 m and 0.2 m/s.
///
/// Bodies of the scenes on paper are 0.5 to 8 m in size, so half extents for extents, or one axis for another, change
/// an answer by more.
std::string what_is_wrong(const AnyAnswer& expected, const AnyAnswer& said);

}  // namespace touchstone::app
