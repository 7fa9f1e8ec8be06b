// How far a parabola takes a point along one axis.
#pragma once

#include "model/frame.h"

namespace touchstone::fast::outward {

/// Holds { v t + a t²/2 : 0 ≤ t ≤ duration }, its ends at most 16 u (|v| T + |a| T²/2) + 2^-1060 (1 + T)² further out
/// than the exact ones; everything where that sum overflows. v, a and the answer in multiples of `unit`.
Interval displacement(double v, double a, double duration);

}  // namespace touchstone::fast::outward
