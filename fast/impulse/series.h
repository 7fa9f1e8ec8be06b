// Power series that represent a phase of a solution.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace touchstone::fast::impulse {

/// One more than the greatest order in use (fast/impulse/phase.cpp).
inline constexpr std::size_t most_terms = 33;

/// x_0 + x_1 t + … + x_order t^order; 0 at first. Further coefficients are not set: to clear them all, and to copy
/// them, would take longer than many a sum.
struct Series {
  std::array<double, most_terms> x;
  std::size_t order = 0;

  Series() { x[0] = 0; }

  double operator()(double t) const {
    double sum = x[order];
    for (std::size_t n = order; n-- > 0;) sum = sum * t + x[n];
    return sum;
  }

  struct Value {
    double value, slope;
  };
  Value both(double t) const {
    double value = x[order], slope = 0;
    for (std::size_t n = order; n-- > 0;) {
      slope = slope * t + value;
      value = value * t + x[n];
    }
    return {value, slope};
  }
};

/// The values of series of one order, side by side: a single sum waits for its own additions.
template <std::size_t count>
std::array<double, count> values(const std::array<const Series*, count>& series, double t) {
  std::array<double, count> sums;
  const std::size_t order = series[0]->order;
  for (std::size_t k = 0; k < count; ++k) sums[k] = series[k]->x[order];
  for (std::size_t n = order; n-- > 0;) {
    for (std::size_t k = 0; k < count; ++k) sums[k] = sums[k] * t + series[k]->x[n];
  }
  return sums;
}

/// t with |coefficient| tⁿ ≤ 2^-56, from exponents alone: no C library's logarithm has the same bits everywhere.
double length_for(double coefficient, std::size_t n);

/// The greatest t at which the last two terms stay below 2^-56 of the unit.
double length_of(const Series& x, double unit);

/// The first t in [0, length] at which the series, which starts below the target, reaches it; nothing if it does not.
/// If the series rises and then falls short, closest_miss is reduced to the difference at its maximum.
std::optional<double> first_reach(const Series& x, double target, double length, double& closest_miss);

}  // namespace touchstone::fast::impulse
