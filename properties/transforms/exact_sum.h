// Sums of doubles that are proved not to round.
#pragma once

#include <cmath>
#include <initializer_list>
#include <optional>

#include "model/frame.h"

namespace touchstone::properties {

/// The sum of the terms if no partial sum, from the left, rounds or overflows. (Knuth's two-sum: its error term is
/// exact.)
inline std::optional<double> exact_sum(std::initializer_list<double> terms) {
  double sum = 0;
  for (const double term : terms) {
    const double s = sum + term, term_kept = s - sum;
    if (!std::isfinite(s) || (sum - (s - term_kept)) + (term - term_kept) != 0) return std::nullopt;
    sum = s;
  }
  return sum;
}

inline std::optional<Vec3> exact_sum(const Vec3& a, const Vec3& b) {
  const auto x = exact_sum({a.x(), b.x()}), y = exact_sum({a.y(), b.y()}), z = exact_sum({a.z(), b.z()});
  if (!x || !y || !z) return std::nullopt;
  return Vec3(*x, *y, *z);
}

}  // namespace touchstone::properties
