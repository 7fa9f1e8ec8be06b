#include "fast/impulse/stop.h"

#include <array>
#include <cmath>

#include "fast/impulse/turning.h"

namespace touchstone::fast::impulse {
namespace {

/// tan of half the turn that is left. A choice: from farther away slip is followed by phases (fast/impulse/phase.h),
/// which also end at the stop, in more steps.
constexpr double farthest = 0.5;

/// A choice: a series that needs more terms converges slower than phases do.
constexpr std::size_t terms = 64;

struct Direction {
  double c = 1, d = 0;
};

Direction turned(const Direction& from, double tan_half) {
  const double D = 1 + tan_half * tan_half, c = (1 - tan_half) * (1 + tan_half) / D, d = 2 * tan_half / D;
  return {from.c * c - from.d * d, from.d * c + from.c * d};
}

/// The root of η near a direction, by Newton's method.
std::optional<Direction> stopping_direction(const Impact& i, Direction at) {
  for (int step = 0; step < 6; ++step) {
    const double eta = i.k2 * at.c - i.k1 * at.d + i.mu * (i.l1 - i.l2) * at.c * at.d;
    const double slope = -i.k1 * at.c - i.k2 * at.d + i.mu * (i.l1 - i.l2) * (at.c - at.d) * (at.c + at.d);
    if (!(slope < 0)) return std::nullopt;
    const double tan_half = -0.5 * eta / slope;  // of a small angle
    if (std::abs(tan_half) > 2 * farthest) return std::nullopt;
    at = turned(at, tan_half);
    if (std::abs(tan_half) < 0x1p-28) return at;  // the next step would be below rounding
  }
  return std::nullopt;
}

}  // namespace

std::optional<Stop> until_stop(const Impact& i, const ImpactState& at) {
  const auto root = stopping_direction(i, {at.c, at.d});
  if (!root) return std::nullopt;
  const auto [C, S] = *root;
  const Turning x = turning(i, C, S);
  const double g0 = x.g[0], slope = x.eta[1] / 2;
  if (!(g0 < 0) || !(slope < 0)) return std::nullopt;
  const double along = at.c * C + at.d * S, across = at.d * C - at.c * S;
  const double t = across / (1 + along);
  if (!(along > 0) || std::abs(t) > farthest) return std::nullopt;
  const auto& E = x.eta;  // E[0] is 0 at a root
  const auto turns_there = [&](double from) { return E[1] + from * (E[2] + from * (E[3] + from * E[4])) < 0; };
  if (!turns_there(t) || !turns_there(t / 2)) return std::nullopt;  // another root is closer
  const std::array<double, 7> q{0, E[1] / 2, E[2] / 2, (E[3] + E[1]) / 2, (E[4] + E[2]) / 2, E[3] / 2, E[4] / 2};
  constexpr std::array<double, 5> one_plus_t2_squared{1, 0, 2, 0, 1};
  std::array<double, terms> phi;
  double sum = 0, power = 1;
  int small = 0;
  for (std::size_t n = 0; n < terms; ++n) {
    double rest = n < 5 ? -one_plus_t2_squared[n] : 0;
    for (std::size_t j = 2; j <= 6 && j <= n; ++j) rest -= q[j] * static_cast<double>(n + 1 - j) * phi[n + 1 - j];
    for (std::size_t j = 1; j <= 4 && j <= n; ++j) rest -= x.g[j] * phi[n - j];
    phi[n] = rest / (static_cast<double>(n) * q[1] + g0);
    const double term = phi[n] * power;
    sum += term;
    power *= t;
    if (n == 12 && std::abs(term) > 0x1p-8 * std::abs(sum)) return std::nullopt;  // it will not converge in time
    small = std::abs(term) <= 0x1p-58 * std::abs(sum) ? small + 1 : 0;
    if (small == 2) return Stop{at.s * sum, 2 * std::abs(t)};
  }
  return std::nullopt;
}

}  // namespace touchstone::fast::impulse
