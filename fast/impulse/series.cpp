#include "fast/impulse/series.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchstone::fast::impulse {
namespace {

/// Newton's method inside a shrinking bracket where x rises from below the target to it or above. It squares its error:
/// a step of 2^-28 of the bracket is the last that matters.
double crossing(const Series& x, double target, double lo, double hi) {
  const double below = x(lo) - target, above = x(hi) - target;
  double t = lo + (hi - lo) * (below / (below - above));
  for (int step = 0; step < 100; ++step) {
    const auto [value, slope] = x.both(t);
    const double off = value - target, newton = t - off / slope;
    (off < 0 ? lo : hi) = t;
    if (!(newton >= lo && newton <= hi)) {
      t = lo + (hi - lo) / 2;
    } else if (std::abs(newton - t) <= 0x1p-28 * hi) {
      return newton;
    } else {
      t = newton;
    }
  }
  return t;
}

/// Where x, which rises at lo and falls at hi, is greatest: bisection of the sign of its slope.
double summit(const Series& x, double lo, double hi) {
  for (int step = 0; step < 60; ++step) {
    const double middle = lo + (hi - lo) / 2;
    (x.slope(middle) > 0 ? lo : hi) = middle;
  }
  return lo;
}

}  // namespace

double length_for(double coefficient, std::size_t n) {
  if (!(coefficient > 0)) return std::numeric_limits<double>::max();
  int exponent = 0;
  std::frexp(coefficient, &exponent);
  const double wanted = (-56.0 - exponent) / static_cast<double>(n), whole = std::floor(wanted);
  return std::ldexp(1 + 0.6931471805599453 * (wanted - whole), static_cast<int>(whole));  // 2^f ≥ 1 + f ln 2
}

double length_of(const Series& x, double unit) {
  return std::min(length_for(std::abs(x.x[x.order]) / unit, x.order),
                  length_for(std::abs(x.x[x.order - 1]) / unit, x.order - 1));
}

std::optional<double> first_reach(const Series& x, double target, double length, double& closest_miss) {
  if (x(length) >= target) return crossing(x, target, 0, length);
  if (!(x.slope(0) > 0 && x.slope(length) < 0)) return std::nullopt;
  const double top = summit(x, 0, length), miss = x(top) - target;
  closest_miss = std::min(closest_miss, std::abs(miss));
  return miss >= 0 ? std::optional(crossing(x, target, 0, top)) : std::nullopt;
}

}  // namespace touchstone::fast::impulse
