#include "fast/impulse/series.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace touchstone::fast::impulse {
namespace {

/// How much of the change of a slope within a series its rounding may be. A choice: u_n is known to some 2^-50 of its
/// terms. Where it changes by less than 2^-20 of them within a series, a negative slope counts as falling.
constexpr double rounded_slope = 0x1p-30;

/// Newton's method inside a shrinking bracket where x rises from below the target to it or above. It squares its error:
/// a step of 2^-28 of the root is the last that matters. (Not of the bracket: it may be 2^30 times as long as the
/// root.) `below` and `above`: x − target at lo and hi.
double crossing(const Series& x, double target, double lo, double hi, double below, double above) {
  double t = lo + (hi - lo) * (below / (below - above));
  for (int step = 0; step < 100; ++step) {
    const auto [value, slope] = x.both(t);
    const double off = value - target, newton = t - off / slope;
    (off < 0 ? lo : hi) = t;
    if (!(newton >= lo && newton <= hi)) {
      t = lo + (hi - lo) / 2;
    } else if (std::abs(newton - t) <= 0x1p-28 * newton) {
      return newton;
    } else {
      t = newton;
    }
  }
  return t;
}

/// Where x, which rises at lo and falls at hi, is greatest: 60 bisections of the sign of its slope. Three at a time
/// need one of four intervals each: the slopes at all seven inner ends are computed side by side, since a single sum
/// waits for its own additions.
double summit(const Series& x, double lo, double hi) {
  constexpr std::size_t intervals = 8;
  for (int step = 0; step < 60; step += 3) {
    std::array<double, intervals + 1> end;
    end[0] = lo;
    end[intervals] = hi;
    for (std::size_t width = intervals; width > 1; width /= 2) {
      for (std::size_t i = 0; i < intervals; i += width) end[i + width / 2] = end[i] + (end[i + width] - end[i]) / 2;
    }
    std::array<double, intervals> value, slope;
    value.fill(x.x[x.order]);
    slope.fill(0);
    for (std::size_t n = x.order; n-- > 0;) {
      for (std::size_t i = 0; i < intervals; ++i) {
        slope[i] = slope[i] * end[i] + value[i];
        value[i] = value[i] * end[i] + x.x[n];
      }
    }
    std::size_t at = 0;
    for (std::size_t width = intervals / 2; width > 0; width /= 2) at += slope[at + width] > 0 ? width : 0;
    lo = end[at];
    hi = end[at + 1];
  }
  return lo;
}

// What frexp, floor and ldexp give, without calls.

int exponent_of(double x) {
  const auto field = static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52);
  if (field > 0 && field < 0x7ff) return field - 1022;
  int exponent = 0;
  std::frexp(x, &exponent);
  return exponent;
}

double floor_of(double x) {
  const double towards_zero = static_cast<int>(x);
  return towards_zero - (towards_zero > x ? 1 : 0);
}

double times_power_of_two(double x, int exponent) {
  if (std::abs(exponent) > 1000) return std::ldexp(x, exponent);
  return x * std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

}  // namespace

double length_for(double coefficient, std::size_t n) {
  if (!(coefficient > 0)) return std::numeric_limits<double>::max();
  const double wanted = (-56.0 - exponent_of(coefficient)) / static_cast<double>(n), whole = floor_of(wanted);
  return times_power_of_two(1 + 0.6931471805599453 * (wanted - whole), static_cast<int>(whole));  // 2^f ≥ 1 + f ln 2
}

double length_of(const Series& x, double unit) {
  return std::min(length_for(std::abs(x.x[x.order]) / unit, x.order),
                  length_for(std::abs(x.x[x.order - 1]) / unit, x.order - 1));
}

std::optional<double> first_reach(const Series& x, double target, double length, double& closest_miss) {
  const double start = x.x[0], slope_at_start = x.x[1];
  const auto [end, slope_at_end] = x.both(length);
  if (end >= target) return crossing(x, target, 0, length, start - target, end - target);
  // Work is restored from where u_n is 0, so its slope begins with 0, but for rounding: a share of how much it changes.
  const bool rises = slope_at_start > 0 || (x.x[2] > 0 && slope_at_start >= -rounded_slope * x.x[2] * length);
  if (!(rises && slope_at_end < 0)) return std::nullopt;
  const double top = summit(x, 0, length), miss = x(top) - target;
  closest_miss = std::min(closest_miss, std::abs(miss));
  return miss >= 0 ? std::optional(crossing(x, target, 0, top, start - target, miss)) : std::nullopt;
}

}  // namespace touchstone::fast::impulse
