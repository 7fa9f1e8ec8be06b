// The numbers of scenes that fuzzing makes.
#pragma once

#include <cmath>

namespace touchstone::properties::fuzzing {

/// 0, or of a size at which the bounds of `oracle/tolerance` hold: products of six lengths are far from overflow.
inline bool is_usual(double number) {
  constexpr int greatest_exponent = 100;
  return number == 0 || (std::isfinite(number) && std::abs(std::ilogb(number)) <= greatest_exponent);
}

}  // namespace touchstone::properties::fuzzing
