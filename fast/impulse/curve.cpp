#include "fast/impulse/curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "fast/impulse/stop.h"

namespace touchstone::fast::impulse {
namespace {

constexpr std::size_t order = 20;
using Series = std::array<double, order + 1>;

/// Rates are of this size, and τ is counted in its inverse.
double rate(const Impact& i) { return std::abs(i.k1) + std::abs(i.k2) + i.mu * std::max(i.l1, i.l2); }

struct Step {
  Series c, d, s;
  Series P1, P2, p;  ///< what is added to the impulse
  double length = 0;
};

double product(const Series& x, const Series& y, std::size_t n) {
  double sum = 0;
  for (std::size_t j = 0; j <= n; ++j) sum += x[j] * y[n - j];
  return sum;
}

double value(const Series& x, double tau) {
  double sum = x[order];
  for (std::size_t n = order; n-- > 0;) sum = sum * tau + x[n];
  return sum;
}

double slope(const Series& x, double tau) {
  double sum = static_cast<double>(order) * x[order];
  for (std::size_t n = order; n-- > 1;) sum = sum * tau + static_cast<double>(n) * x[n];
  return sum;
}

/// τ with |x_n| τⁿ ≤ 2^-56, by exponents alone: no logarithm of the C library has the same bits everywhere.
double length_for(double coefficient, std::size_t n) {
  if (!(coefficient > 0)) return std::numeric_limits<double>::max();
  int exponent = 0;
  std::frexp(coefficient, &exponent);
  const double wanted = (-56.0 - exponent) / static_cast<double>(n), whole = std::floor(wanted);
  return std::ldexp(1 + 0.6931471805599453 * (wanted - whole), static_cast<int>(whole));  // 2^f ≥ 1 + f ln 2
}

Step step_from(const Impact& i, const Course& at) {
  const double unit = 1 / rate(i);
  const double k1 = i.k1 * unit, k2 = i.k2 * unit, m1 = i.mu * i.l1 * unit, m2 = i.mu * i.l2 * unit;
  Step step;
  Series eta, g;
  step.c[0] = at.c;
  step.d[0] = at.d;
  step.s[0] = at.s;
  step.P1[0] = step.P2[0] = step.p[0] = 0;
  for (std::size_t n = 0; n < order; ++n) {
    double cd = 0, cc = 0;  // Cauchy products; side by side, since one sum alone waits for its own additions
    for (std::size_t j = 0; j <= n; ++j) {
      cd += step.c[j] * step.d[n - j];
      cc += step.c[j] * step.c[n - j];
    }
    eta[n] = k2 * step.c[n] - k1 * step.d[n] + (m1 - m2) * cd;
    g[n] = k1 * step.c[n] + k2 * step.d[n] - (m1 - m2) * cc - (n == 0 ? m2 : 0);
    double d_eta = 0, c_eta = 0, s_g = 0, s_c = 0, s_d = 0;
    for (std::size_t j = 0; j <= n; ++j) {
      d_eta += step.d[j] * eta[n - j];
      c_eta += step.c[j] * eta[n - j];
      s_g += step.s[j] * g[n - j];
      s_c += step.s[j] * step.c[n - j];
      s_d += step.s[j] * step.d[n - j];
    }
    const double next = 1 / static_cast<double>(n + 1);
    step.c[n + 1] = -d_eta * next;
    step.d[n + 1] = c_eta * next;
    step.s[n + 1] = s_g * next;
    step.p[n + 1] = step.s[n] * next * unit;
    step.P1[n + 1] = -i.mu * s_c * next * unit;
    step.P2[n + 1] = -i.mu * s_d * next * unit;
  }
  const auto last = [&](std::size_t n) {
    return std::max({std::abs(step.c[n]), std::abs(step.d[n]), std::abs(step.s[n]) / at.s});
  };
  step.length = std::min({length_for(last(order), order), length_for(last(order - 1), order - 1), 8.0});
  return step;
}

/// u_n along the step.
Series speed(const Impact& i, const Course& at, const Step& step) {
  Series u;
  u[0] = normal_speed(i, at);
  for (std::size_t n = 1; n <= order; ++n) u[n] = i.k1 * step.P1[n] + i.k2 * step.P2[n] + i.b * step.p[n];
  return u;
}

/// W_n along the step; dW/dτ = s u_n.
Series work(const Impact& i, const Step& step, const Series& u) {
  const double unit = 1 / rate(i);
  Series W;
  W[0] = 0;
  for (std::size_t n = 0; n < order; ++n) W[n + 1] = product(step.s, u, n) / static_cast<double>(n + 1) * unit;
  return W;
}

/// The root of x − target in [lo, hi], where x rises from below the target to it or above: Newton's method inside a
/// shrinking bracket.
double crossing(const Series& x, double target, double lo, double hi) {
  double tau = lo + (hi - lo) / 2;
  for (int step = 0; step < 100; ++step) {
    const double off = value(x, tau) - target;
    (off < 0 ? lo : hi) = tau;
    const double newton = tau - off / slope(x, tau);
    const double next = newton > lo && newton < hi ? newton : lo + (hi - lo) / 2;
    if (std::abs(next - tau) <= 0x1p-54 * hi) return next;
    tau = next;
  }
  return tau;
}

/// Where x, which rises at lo and falls at hi, is greatest: bisection of the sign of its slope.
double summit(const Series& x, double lo, double hi) {
  for (int step = 0; step < 60; ++step) {
    const double middle = lo + (hi - lo) / 2;
    (slope(x, middle) > 0 ? lo : hi) = middle;
  }
  return lo;
}

/// Where in the step the goal is reached; none if it is not.
std::optional<double> reached(const Series& x, double target, double length, double& closest_miss) {
  if (value(x, length) >= target) return crossing(x, target, 0, length);
  if (!(slope(x, 0) > 0 && slope(x, length) < 0)) return std::nullopt;
  const double top = summit(x, 0, length), miss = value(x, top) - target;
  closest_miss = std::min(closest_miss, std::abs(miss));
  return miss >= 0 ? std::optional(crossing(x, target, 0, top)) : std::nullopt;
}

void advance(const Step& step, double W, double tau, Course& at) {
  const double c = value(step.c, tau), d = value(step.d, tau), length = std::sqrt(c * c + d * d);
  at.c = c / length;
  at.d = d / length;
  at.s = std::max(value(step.s, tau), 0.0);
  at.P1 += value(step.P1, tau);
  at.P2 += value(step.P2, tau);
  at.p += value(step.p, tau);
  at.work += W;
}

/// Slip stops before the goal: from the series for the impulse that is left, if it says so.
bool stops(const Impact& i, const Goal& goal, Course& at) {
  if (i.law == Law::stronge) return false;  // the series says nothing about work
  const auto left = impulse_until_stop(i, at);
  if (!left) return false;
  Course end = at;
  end.p += *left;
  end.P1 -= (at.s * at.c + i.k1 * *left) / i.l1;  // u_t = 0
  end.P2 -= (at.s * at.d + i.k2 * *left) / i.l2;
  end.s = 0;
  if (goal.of == Goal::Of::impulse && end.p >= goal.value) return false;
  // On the way u_n must not pass the goal and come back: its slope keeps its sign over the arc that is left.
  const double h = i.b - i.mu * (i.k1 * at.c + i.k2 * at.d), k = std::sqrt(i.k1 * i.k1 + i.k2 * i.k2);
  const bool one_way = i.b > i.mu * k || std::abs(h) > widest_arc * i.mu * k;
  if (goal.of == Goal::Of::speed && (!one_way || normal_speed(i, end) >= goal.value)) return false;
  at = end;
  return true;
}

}  // namespace

bool is_straight(const Impact& i, const Course& at) {
  const double eta = i.k2 * at.c - i.k1 * at.d + i.mu * (i.l1 - i.l2) * at.c * at.d;
  return std::abs(eta) <= 0x1p-50 * rate(i);
}

CurveEnd go_round(const Impact& i, const Goal& goal, Course& at, double& closest_miss) {
  const double speeds = std::abs(i.u1) + std::abs(i.u2) + std::abs(i.un);
  while (at.s > 0x1p-70 * speeds) {
    if (is_straight(i, at)) return CurveEnd::straightened;
    if (stops(i, goal, at)) return CurveEnd::stop;
    const Step step = step_from(i, at);
    const Series u = speed(i, at, step);
    const Series W = i.law == Law::stronge ? work(i, step, u) : Series{};
    const Series& x = goal.of == Goal::Of::speed ? u : goal.of == Goal::Of::work ? W : step.p;
    const double before = goal.of == Goal::Of::work ? at.work : goal.of == Goal::Of::impulse ? at.p : 0;
    const auto here = reached(x, goal.value - before, step.length, closest_miss);
    const double tau = here.value_or(step.length);
    advance(step, value(W, tau), tau, at);
    if (here && goal.of == Goal::Of::impulse) at.p = goal.value;
    if (here) return CurveEnd::goal;
  }
  at.s = 0;
  return CurveEnd::stop;
}

}  // namespace touchstone::fast::impulse
