// Power series that represent a phase of a solution.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace touchstone::fast::impulse {

/// One more than the greatest order in use (fast/impulse/phase.cpp).
inline constexpr std::size_t most_terms = 33;

/// x_0 + x_1 t + … + x_order t^order.
struct Series {
  std::array<double, most_terms> x{};
  std::size_t order = 0;

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

  double slope(double t) const { return both(t).slope; }
};

/// t with |coefficient| tⁿ ≤ 2^-56, from exponents alone: no C library's logarithm has the same bits everywhere.
double length_for(double coefficient, std::size_t n);

/// The greatest t at which the last two terms stay below 2^-56 of the unit.
double length_of(const Series& x, double unit);

/// The first t in [0, length] at which the series, which starts below the target, reaches it; nothing if it does not.
/// If the series rises and then falls short, closest_miss is reduced to the difference at its maximum.
std::optional<double> first_reach(const Series& x, double target, double length, double& closest_miss);

}  // namespace touchstone::fast::impulse
