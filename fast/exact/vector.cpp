#include "fast/exact/vector.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchstone::fast::exact {
namespace {

long greatest_exponent(const Vector& v) {
  long greatest = std::numeric_limits<long>::min();
  for (const Dyadic* c : {&v.x, &v.y, &v.z}) {
    if (c->sign() != 0) greatest = std::max(greatest, c->scientific().exponent);
  }
  return greatest;
}

/// A product of powers of two that doubles can represent, since k may be beyond their range.
Dyadic power_of_two(long k) {
  Dyadic power = 1;
  constexpr long step = 1000;  // 2^1000 and 2^-1000 are normal doubles
  for (; k >= step; k -= step) power = power * std::ldexp(1.0, step);
  for (; k <= -step; k += step) power = power * std::ldexp(1.0, -step);
  return power * std::ldexp(1.0, static_cast<int>(k));
}

}  // namespace

Vec3 direction(const Vector& v) {
  const long k = greatest_exponent(v);
  const auto scaled = [k](const Dyadic& c) {
    const Dyadic::Scientific s = c.scientific();
    return std::ldexp(s.m, static_cast<int>(std::max(s.exponent - k, -3000L)));
  };
  return {scaled(v.x), scaled(v.y), scaled(v.z)};
}

Vector at_unit_scale(const Vector& v) { return power_of_two(-greatest_exponent(v)) * v; }

}  // namespace touchstone::fast::exact
