// The displacement of a point on a parabola, along one axis.
#pragma once

#include "model/frame.h"

namespace touchstone::fast::outward {

/// Contains { v t + a t²/2 : 0 ≤ t ≤ duration }; its ends are at most 16 u (|v| T + |a| T²/2) + 2^-1060 (1 + T)²
/// farther out than the exact ones, and infinite if that sum overflows. v, a and the result are in multiples of `unit`.
Interval displacement(double v, double a, double duration);

}  // namespace touchstone::fast::outward
