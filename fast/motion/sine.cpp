#include "fast/motion/sine.h"

namespace touchstone::fast::motion {
namespace {

constexpr double half_pi_high = 0x1.921fb544p+0;       // 33 bits
constexpr double half_pi_low = 0x1.0b4611a626331p-34;  // the next 53
constexpr double two_over_pi = 0x1.45f306dc9c883p-1;

/// The nearest whole number: the addition shifts out all fractional bits.
double rounded(double x) {
  constexpr double no_fractions = 0x1.8p52;
  return (x + no_fractions) - no_fractions;
}

double sine_of_small(double r) {
  const double s = r * r;
  double sum = 1.0 / 355687428096000;  // 17!
  sum = sum * s - 1.0 / 1307674368000;
  sum = sum * s + 1.0 / 6227020800;
  sum = sum * s - 1.0 / 39916800;
  sum = sum * s + 1.0 / 362880;
  sum = sum * s - 1.0 / 5040;
  sum = sum * s + 1.0 / 120;
  sum = sum * s - 1.0 / 6;
  return r + r * (s * sum);
}

double cosine_of_small(double r) {
  const double s = r * r;
  double sum = -1.0 / 6402373705728000;  // 18!
  sum = sum * s + 1.0 / 20922789888000;
  sum = sum * s - 1.0 / 87178291200;
  sum = sum * s + 1.0 / 479001600;
  sum = sum * s - 1.0 / 3628800;
  sum = sum * s + 1.0 / 40320;
  sum = sum * s - 1.0 / 720;
  sum = sum * s + 1.0 / 24;
  sum = sum * s - 1.0 / 2;
  return 1 + s * sum;
}

}  // namespace

SineCosine sine_cosine(double x) {
  const double k = rounded(x * two_over_pi);
  const double r = (x - k * half_pi_high) - k * half_pi_low;
  const double s = sine_of_small(r);
  const double c = cosine_of_small(r);
  switch (static_cast<long long>(k) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

}  // namespace touchstone::fast::motion
