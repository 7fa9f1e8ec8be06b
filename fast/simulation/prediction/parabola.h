// The time at which a gap that is a quadratic function of time closes.
#pragma once

#include <cmath>

#include "model/frame.h"
#include "model/infinity.h"

namespace touchstone::fast::simulation {

inline constexpr double never = infinity;

/// The first t ≥ 0 at which c + b t + a t²/2 is ≤ 0 and does not rise; infinity if there is none. If it is ≤ 0 from the
/// start but rises at first, the result is the time at which it stops rising. With b = a = 0 and c ≤ 0 the result is
/// infinity: nothing closes.
///
/// The forms of the quadratic formula are stable: nearly equal numbers are subtracted in the discriminant only. Its
/// rounding, a few u of b², changes the gap by a few u of c, which is no more than the error of the gap itself. This
/// does not hold if c is half the square of a distance less a far smaller reach²: use sphere_closing_time.
inline double closing_time(double c, double b, double a, double discriminant) {
  if (c > 0) {
    if (discriminant < 0 || (b >= 0 && a >= 0)) return never;
    const double root = std::sqrt(discriminant);
    return b < 0 ? 2 * c / (root - b) : (b + root) / -a;
  }
  if (b < 0 || (b == 0 && a < 0 && c == 0)) return 0;
  if (a >= 0) return never;
  return discriminant > 0 ? (b + std::sqrt(discriminant)) / -a : b / -a;
}

inline double closing_time(double c, double b, double a) { return closing_time(c, b, a, b * b - 2 * a * c); }

/// The first time at which a point at s with velocity v is at the distance `reach` from the origin: the closing time of
/// (|s + v t|² − reach²)/2. Requires s·v < 0, |s| and |v| below 2^250, and |s| above 2^-250 (fast/simulation/range.h).
double sphere_closing_time(const Vec3& s, const Vec3& v, double reach);

}  // namespace touchstone::fast::simulation
