#include "fast/impulse/phase.h"

#include <algorithm>
#include <cmath>

#include "fast/impulse/turning.h"

namespace touchstone::fast::impulse {
namespace {

/// A choice: a higher order makes phases longer and each of them dearer. By direction the n-th term costs the same as
/// the first, by time it costs n times as much (fast/impulse/phase.h).
constexpr std::size_t time_order = 20, direction_order = 32;

/// Near a root of η the direction hardly changes while s does, so it determines s with ever fewer digits: time is
/// better. The limits are choices between the two ways, which agree where both apply: they decide about time alone.
constexpr double slowest_turn = 1.0 / 32;  // relative to rate()
constexpr double shortest_turn = 1.0 / 64;

/// tan of half a turn of 53°. A choice: beyond it the series seldom converges within its order.
constexpr double longest_turn = 0.5;

/// In units of 1/rate. The terms of the series limit most phases. Near a double root of η slip turns by 1/t, so each
/// phase is some times as long as all before it: a limit of 8 made millions of them.
constexpr double longest_time = 0x1p20;

constexpr auto inverses = [] {
  std::array<double, most_terms + 1> all{};
  for (std::size_t n = 1; n < all.size(); ++n) all[n] = 1.0 / static_cast<double>(n);
  return all;
}();

/// For a turn to the right the mirror image is solved.
Turning mirrored(Turning x, double side) {
  for (double* odd : {&x.k2, &x.beta, &x.eta[0], &x.eta[2], &x.eta[4], &x.g[1], &x.g[3]}) *odd *= side;
  return x;
}

}  // namespace

// With E = η (1 + t²)², G = g (1 + t²)²: dθ = 2 dt/(1 + t²) gives E (1 + t²)/2 ds/dt = G s, and r = 2 s/E is (dp/dt)/(1
// + t²), so that dp/dt = (1 + t²) r, along: −mu (1 − t²) r, across: −mu 2 t r.
bool phase_by_direction(const Impact& i, const ImpactState& at, Phase& all) {
  const Turning straight = turning(i, at.c, at.d);
  if (std::abs(straight.eta[0]) < slowest_turn * rate(i)) return false;
  all.by_direction = true;
  all.c = at.c;
  all.d = at.d;
  all.side = straight.eta[0] < 0 ? -1 : 1;
  const Turning x = mirrored(straight, all.side);
  const auto& E = x.eta;
  const auto& G = x.g;
  const std::array<double, 7> q{E[0] / 2,          E[1] / 2, (E[2] + E[0]) / 2, (E[3] + E[1]) / 2,
                                (E[4] + E[2]) / 2, E[3] / 2, E[4] / 2};
  // Leading zeros save the sums a test of their bounds.
  constexpr std::size_t pad = 6;
  std::array<double, direction_order + 1 + pad> s{}, ds{}, r{};
  const double per_q = 1 / q[0], per_E = 1 / E[0];
  s[pad] = 1;
  for (std::size_t n = 0; n <= direction_order; ++n) {
    const std::size_t m = n + pad;
    r[m] = per_E * (2 * s[m] - E[1] * r[m - 1] - E[2] * r[m - 2] - E[3] * r[m - 3] - E[4] * r[m - 4]);
    if (n == direction_order) break;
    const double gains = G[0] * s[m] + G[1] * s[m - 1] + G[2] * s[m - 2] + G[3] * s[m - 3] + G[4] * s[m - 4];
    // ds[m] is the coefficient of tⁿ in ds/dt.
    ds[m] = per_q * (gains - (q[1] * ds[m - 1] + q[2] * ds[m - 2] + q[3] * ds[m - 3]) -
                     (q[4] * ds[m - 4] + q[5] * ds[m - 5] + q[6] * ds[m - 6]));
    s[m + 1] = ds[m] * inverses[n + 1];
  }
  for (Series* series : {&all.s, &all.along, &all.across, &all.p}) series->order = direction_order;
  for (std::size_t n = 0; n <= direction_order; ++n) all.s.x[n] = at.s * s[n + pad];
  for (std::size_t n = 1; n <= direction_order; ++n) {
    const std::size_t m = n - 1 + pad;
    const double of = at.s * inverses[n];
    all.p.x[n] = of * (r[m] + r[m - 2]);
    all.along.x[n] = -i.mu * of * (r[m] - r[m - 2]);
    all.across.x[n] = -i.mu * of * 2 * r[m - 1];
  }
  const double unit = at.s / rate(i);
  all.length = std::min({length_of(all.s, at.s), length_of(all.p, unit), longest_turn});
  // Slip cannot turn past a root of η, though if s vanishes with it the series may not show it.
  const auto still_turns = [&](double t) { return E[0] + t * (E[1] + t * (E[2] + t * (E[3] + t * E[4]))) > E[0] / 8; };
  while (all.length >= shortest_turn && !(still_turns(all.length) && still_turns(all.length / 2))) all.length /= 2;
  return all.length >= shortest_turn;
}

void phase_by_time(const Impact& i, const ImpactState& at, Phase& all) {
  const double unit = 1 / rate(i);
  const double k1 = i.k1 * unit, k2 = i.k2 * unit, m1 = i.mu * i.l1 * unit, m2 = i.mu * i.l2 * unit;
  all.by_direction = false;
  all.c = 1;
  all.d = 0;
  all.side = 1;
  for (Series* series : {&all.s, &all.along, &all.across, &all.p, &all.turn_c, &all.turn_d}) series->order = time_order;
  auto &c = all.turn_c.x, &d = all.turn_d.x, &s = all.s.x;
  std::array<double, time_order> eta, g;
  c[0] = at.c;
  d[0] = at.d;
  s[0] = at.s;
  for (std::size_t n = 0; n < time_order; ++n) {
    double cd = 0, cc = 0;  // Cauchy products; side by side, since a single sum would wait for its own additions
    for (std::size_t j = 0; j <= n; ++j) {
      cd += c[j] * d[n - j];
      cc += c[j] * c[n - j];
    }
    eta[n] = k2 * c[n] - k1 * d[n] + (m1 - m2) * cd;
    g[n] = k1 * c[n] + k2 * d[n] - (m1 - m2) * cc - (n == 0 ? m2 : 0);
    double d_eta = 0, c_eta = 0, s_g = 0, s_c = 0, s_d = 0;
    for (std::size_t j = 0; j <= n; ++j) {
      d_eta += d[j] * eta[n - j];
      c_eta += c[j] * eta[n - j];
      s_g += s[j] * g[n - j];
      s_c += s[j] * c[n - j];
      s_d += s[j] * d[n - j];
    }
    const double next = inverses[n + 1];
    c[n + 1] = -d_eta * next;
    d[n + 1] = c_eta * next;
    s[n + 1] = s_g * next;
    all.p.x[n + 1] = s[n] * next * unit;
    all.along.x[n + 1] = -i.mu * s_c * next * unit;
    all.across.x[n + 1] = -i.mu * s_d * next * unit;
  }
  all.length = std::min({length_of(all.turn_c, 1), length_of(all.turn_d, 1), length_of(all.s, at.s), longest_time});
}

Series normal_speed(const Impact& i, const Phase& phase, double start) {
  const double along = i.k1 * phase.c + i.k2 * phase.d;
  const double across = phase.side * (i.k2 * phase.c - i.k1 * phase.d);
  Series u;
  u.order = phase.p.order;
  u.x[0] = start;
  for (std::size_t n = 1; n <= u.order; ++n) {
    u.x[n] = along * phase.along.x[n] + across * phase.across.x[n] + i.b * phase.p.x[n];
  }
  return u;
}

Series work(const Phase& phase, const Series& u) {
  Series W;
  W.order = u.order;
  for (std::size_t n = 1; n <= W.order; ++n) {
    double sum = 0;  // of u dp/dt at tⁿ⁻¹
    for (std::size_t j = 1; j <= n; ++j) sum += static_cast<double>(j) * phase.p.x[j] * u.x[n - j];
    W.x[n] = sum * inverses[n];
  }
  return W;
}

void advance(const Phase& phase, double t, double work, ImpactState& at) {
  const auto [s, along, to_the_side, p] = values<4>({&phase.s, &phase.along, &phase.across, &phase.p}, t);
  const double across = phase.side * to_the_side;
  at.P1 += phase.c * along - phase.d * across;
  at.P2 += phase.d * along + phase.c * across;
  at.p += p;
  at.s = std::max(s, 0.0);
  at.work += work;
  double c = 0, d = 0;
  if (phase.by_direction) {
    const double turn_c = (1 - t) * (1 + t), turn_d = 2 * t * phase.side;
    c = phase.c * turn_c - phase.d * turn_d;
    d = phase.d * turn_c + phase.c * turn_d;
  } else {
    const auto [turn_c, turn_d] = values<2>({&phase.turn_c, &phase.turn_d}, t);
    c = turn_c;
    d = turn_d;
  }
  const double length = std::sqrt(c * c + d * d);
  at.c = c / length;
  at.d = d / length;
}

}  // namespace touchstone::fast::impulse
