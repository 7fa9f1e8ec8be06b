#include "fast/outward/displacement.h"

#include <algorithm>
#include <cmath>

#include "fast/outward/outward.h"
#include "model/infinity.h"

namespace touchstone::fast::outward {
namespace {

/// The parabola has its apex within the frame, at t* = −v/a, if v and a have opposite signs and |v| < |a| T. Rounding
/// of the product may admit a t* of at most T (1 + 5u): the parabola is then within |a| (t* − T)²/2 ≤ 25 u² |a| T²/2 of
/// its end, which the error below covers.
bool turns(double v, double a, double duration) {
  return v != 0 && a != 0 && (v < 0) != (a < 0) && std::abs(v) <= std::abs(a) * duration * (1 + 4 * u);
}

}  // namespace

/// Errors of the computed ends, with m = |v| T + |a| T²/2:
///   at T: v T rounds once, a T T/2 twice, the sum once: < 3.1u m
///   at t*: −v (v/a)/2 rounds twice, and |v| |v/a| ≤ |v| T: < 2.1u m
/// m itself and the outward step round by < 4.1u m more. So 8u m covers it. Underflow: v and a have errors of 2^-1075
/// each, which T and T² multiply, and so have the products.
Interval displacement(double v, double a, double duration) {
  const double end_v = v * duration;
  const double end_a = a * duration * (duration / 2);
  const double size = std::abs(end_v) + std::abs(end_a);
  constexpr double everything = infinity;
  if (!(size < everything)) return {-everything, everything};

  Interval range{std::min(0.0, end_v + end_a), std::max(0.0, end_v + end_a)};
  if (turns(v, a, duration)) {
    const double apex = -v * (v / a) / 2;
    range.lo = std::min(range.lo, apex);
    range.hi = std::max(range.hi, apex);
  }
  if (size == 0 && (v == 0 || duration == 0) && (a == 0 || duration == 0)) return range;
  const double error = 8 * u * size + underflow * (1 + duration) * (1 + duration);
  return {range.lo - error, range.hi + error};
}

}  // namespace touchstone::fast::outward
