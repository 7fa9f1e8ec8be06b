// Power series that stand for a stretch of a solution.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace touchstone::fast::impulse {

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

/// t with |coefficient| tⁿ ≤ 2^-56, by exponents alone: no logarithm of the C library has the same bits everywhere.
double length_for(double coefficient, std::size_t n);

/// t up to which the last two terms stay below 2^-56 of the unit.
double length_of(const Series& x, double unit);

/// The first t in [0, length] where the series, which starts below it, reaches the target; none if it does not. A
/// series that rises, then falls short is looked at where it is greatest: by how much it missed makes closest_miss
/// smaller.
std::optional<double> first_reach(const Series& x, double target, double length, double& closest_miss);

}  // namespace touchstone::fast::impulse
