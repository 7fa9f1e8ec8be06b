// When a gap that changes like a parabola closes.
#pragma once

#include <cmath>
#include <limits>

#include "model/frame.h"

namespace touchstone::fast::world {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// The first t ≥ 0 at which c + b t + a t²/2 is ≤ 0 and does not rise; infinity if there is none. Where it stays ≤ 0
/// from the start on but rises at first, the time at which it no longer does. With b = a = 0 and c ≤ 0: infinity,
/// nothing closes.
///
/// Stable forms of the quadratic formula: no difference of nearly equal numbers but in the discriminant. Its rounding,
/// a few u of b², changes the gap by a few u of c: no more than the gap itself is off by. Where c is the square of a
/// distance and the reach is far less than that, this is not so: sphere_closes.
inline double closes(double c, double b, double a, double discriminant) {
  if (c > 0) {
    if (discriminant < 0 || (b >= 0 && a >= 0)) return never;
    const double root = std::sqrt(discriminant);
    return b < 0 ? 2 * c / (root - b) : (b + root) / -a;
  }
  if (b < 0 || (b == 0 && a < 0 && c == 0)) return 0;
  if (a >= 0) return never;
  return discriminant > 0 ? (b + std::sqrt(discriminant)) / -a : b / -a;
}

inline double closes(double c, double b, double a) { return closes(c, b, a, b * b - 2 * a * c); }

/// When a point that is at s and moves with v is `reach` away from the origin for the first time: closes, of
/// (|s + v t|² − reach²)/2. Requires s·v < 0, |s| and |v| below 2^250, and |s| above 2^-250 (fast/simulation/range.h).
double sphere_closes(const Vec3& s, const Vec3& v, double reach);

}  // namespace touchstone::fast::world
