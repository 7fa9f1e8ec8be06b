// When a gap that changes like a parabola closes.
#pragma once

#include <cmath>
#include <limits>

namespace touchstone::fast::world {

inline constexpr double never = std::numeric_limits<double>::infinity();

/// The first t ≥ 0 at which c + b t + a t²/2 is ≤ 0 and does not rise; infinity if there is none. Where it stays ≤ 0
/// from the start on but rises at first, the time at which it no longer does. With b = a = 0 and c ≤ 0: infinity,
/// nothing closes.
///
/// Stable forms of the quadratic formula: no difference of nearly equal numbers but in the discriminant.
inline double closes(double c, double b, double a) {
  const double discriminant = b * b - 2 * a * c;
  if (c > 0) {
    if (discriminant < 0 || (b >= 0 && a >= 0)) return never;
    const double root = std::sqrt(discriminant);
    return b < 0 ? 2 * c / (root - b) : (b + root) / -a;
  }
  if (b < 0 || (b == 0 && a < 0 && c == 0)) return 0;
  if (a >= 0) return never;
  return discriminant > 0 ? (b + std::sqrt(discriminant)) / -a : b / -a;
}

}  // namespace touchstone::fast::world
