#include "fast/impulse/stop.h"

#include <array>
#include <cmath>

namespace touchstone::fast::impulse {
namespace {

constexpr double farthest = 0.5;
constexpr std::size_t terms = 64;

struct Direction {
  double c = 1, d = 0;
};

/// η: how fast slip turns, s dθ/dp.
double turning(const Impact& i, const Direction& at) {
  return i.k2 * at.c - i.k1 * at.d + i.mu * (i.l1 - i.l2) * at.c * at.d;
}

double turning_slope(const Impact& i, const Direction& at) {
  return -i.k1 * at.c - i.k2 * at.d + i.mu * (i.l1 - i.l2) * (at.c - at.d) * (at.c + at.d);
}

Direction turned(const Direction& from, double tan_half) {
  const double D = 1 + tan_half * tan_half, c = (1 - tan_half) * (1 + tan_half) / D, d = 2 * tan_half / D;
  return {from.c * c - from.d * d, from.d * c + from.c * d};
}

/// The root of η near a direction, by Newton's method.
std::optional<Direction> stopping_direction(const Impact& i, Direction at) {
  for (int step = 0; step < 6; ++step) {
    const double slope = turning_slope(i, at), eta = turning(i, at);
    if (!(slope < 0)) return std::nullopt;
    const double tan_half = -0.5 * eta / slope;  // of a small angle
    if (std::abs(tan_half) > 2 * farthest) return std::nullopt;
    at = turned(at, tan_half);
    if (std::abs(tan_half) < 0x1p-28) break;  // the next step would be below rounding
  }
  return at;
}

}  // namespace

std::optional<double> impulse_until_stop(const Impact& i, const Course& at) {
  const auto root = stopping_direction(i, {at.c, at.d});
  if (!root) return std::nullopt;
  // Axes along and across the root; A there is [alpha beta; beta gamma].
  const auto [C, S] = *root;
  const double k1 = i.k1 * C + i.k2 * S, k2 = i.k2 * C - i.k1 * S;
  const double alpha = i.l1 * C * C + i.l2 * S * S, gamma = i.l1 * S * S + i.l2 * C * C;
  const double beta = (i.l2 - i.l1) * C * S;
  const double g0 = k1 - i.mu * alpha, slope = -k1 + i.mu * (alpha - gamma);
  if (!(g0 < 0) || !(slope < 0)) return std::nullopt;
  const double along = at.c * C + at.d * S, across = at.d * C - at.c * S;
  const double t = across / (1 + along);
  if (!(along > 0) || std::abs(t) > farthest) return std::nullopt;
  // η (1 + t²)² and g (1 + t²)² as polynomials in t; η's constant term is 0 at a root.
  const double H1 = 2 * slope, H2 = 6 * i.mu * beta, H3 = -2 * k1 - 2 * i.mu * (alpha - gamma), H4 = -k2 - i.mu * beta;
  const std::array<double, 7> q{0, H1 / 2, H2 / 2, (H3 + H1) / 2, (H4 + H2) / 2, H3 / 2, H4 / 2};
  const std::array<double, 5> G{g0, 2 * k2 - 4 * i.mu * beta, 2 * i.mu * alpha - 4 * i.mu * gamma,
                                2 * k2 + 4 * i.mu * beta, -k1 - i.mu * alpha};
  constexpr std::array<double, 5> one_plus_t2_squared{1, 0, 2, 0, 1};
  std::array<double, terms> phi{};
  double sum = 0, power = 1;
  int small = 0;
  for (std::size_t n = 0; n < terms; ++n) {
    double rest = n < 5 ? -one_plus_t2_squared[n] : 0;
    for (std::size_t j = 2; j <= 6 && j <= n; ++j) rest -= q[j] * static_cast<double>(n + 1 - j) * phi[n + 1 - j];
    for (std::size_t j = 1; j <= 4 && j <= n; ++j) rest -= G[j] * phi[n - j];
    phi[n] = rest / (static_cast<double>(n) * q[1] + g0);
    const double term = phi[n] * power;
    sum += term;
    power *= t;
    small = std::abs(term) <= 0x1p-58 * std::abs(sum) ? small + 1 : 0;
    if (small == 2) return at.s * sum;
  }
  return std::nullopt;
}

}  // namespace touchstone::fast::impulse
