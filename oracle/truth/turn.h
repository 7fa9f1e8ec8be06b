// The rotation of a body whose angular velocity changes evenly. In long double, for judging.
#pragma once

#include "oracle/truth/impact.h"

namespace touchstone::oracle {

/// R(seconds) R(0)⁻¹ for R' = [ω]× R, ω = from + (until − from) t/seconds (rad/s, in W): since rotations about
/// different axes do not commute, it is not the rotation by ∫ ω dt. Requires `is_short_turn`.
///
/// Error: at most 2⁻³⁰ rad for each piece of the motion, of which there are 1 + X, X = max(|ω|, √|ω'|) · seconds (the
/// greatest |ω|). Derived in oracle/truth/turn.cpp.
Matrix turn(const Point& from, const Point& until, Real seconds);

/// rad: that error.
Real turn_error(const Point& from, const Point& until, Real seconds);

/// Whether X is at most 2⁸, so that `turn` takes milliseconds.
bool is_short_turn(const Point& from, const Point& until, Real seconds);

}  // namespace touchstone::oracle
