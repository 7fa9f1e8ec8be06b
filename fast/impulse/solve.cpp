#include "fast/impulse/solve.h"

#include <algorithm>
#include <cmath>

#include "fast/impulse/curve.h"
#include "fast/impulse/restart.h"
#include "fast/impulse/straight.h"
#include "fast/mark.h"
#include "fast/rounding.h"

namespace touchstone::fast::impulse {
namespace {

/// Where u_n should be 0, rounding leaves less than this, relative to |u| and to the terms whose sum u_n is: near
/// jamming they are far greater than |u|. A choice: some ten roundings in each of a few phases. A speed below it counts
/// as 0.
constexpr double noise = 64 * 0x1p-53;

class ImpactSolver {
 public:
  explicit ImpactSolver(const Impact& impact)
      : i_(impact), speeds_(std::abs(impact.u1) + std::abs(impact.u2) + std::abs(impact.un)), jams_(may_jam(impact)) {
    const double greater = std::max(std::abs(impact.u1), std::abs(impact.u2));
    if (greater > 0) {  // by ratios: the square of a slip of 1e-170 underflows
      const double x = impact.u1 / greater, y = impact.u2 / greater, length = std::sqrt(x * x + y * y);
      at_.s = greater * length;
      at_.c = x / length;
      at_.d = y / length;
    }
    // The impulse is discontinuous at u_n = 0. (With infinite friction any approach stops the slip.)
    if (jams_ || (std::isinf(impact.mu) && at_.s > 0)) closest_miss_ = std::abs(impact.un);
    if (std::isinf(impact.mu)) stick_at_once();
  }

  Outcome run() {
    outcome_.regime.approached = i_.un < 0;
    if (outcome_.regime.approached) bounce();
    outcome_.miss = closest_miss_ / speeds_;
    return outcome_;
  }

 private:
  /// Compresses and restores until the bodies separate.
  void bounce() {
    do {
      const double before = at_.p;
      at_.work = 0;
      go({Goal::Of::speed, 0});
      note_slope();
      if (before == 0) outcome_.compression = at_.p;
      restore(at_.p - before);
    } while (approaches_again());
    outcome_.P1 = at_.P1;
    outcome_.P2 = at_.P2;
    outcome_.p = at_.p;
  }

  void stick_at_once() {
    at_.P1 = -i_.u1 / i_.l1;
    at_.P2 = -i_.u2 / i_.l2;
    at_.s = 0;
  }

  void restore(double compression) {
    if (i_.e == 0) return;
    switch (i_.law) {
      case Law::poisson:
        return go({Goal::Of::impulse, at_.p + i_.e * compression});
      case Law::stronge: {
        const double regained = -i_.e * i_.e * at_.work;
        at_.work = 0;  // counted from here on: added to the whole, a small e² would be lost
        return go({Goal::Of::work, regained});
      }
      case Law::newton:
        go({Goal::Of::speed, -i_.e * i_.un});
        note_slope();
    }
  }

  /// Bodies that stick have a slope 1/(K⁻¹)_nn, which cond(K) bounds.
  void note_slope() {
    if (!jams_ || at_.s == 0) return;
    const double slope = (i_.b - i_.mu * (i_.k1 * at_.c + i_.k2 * at_.d)) / i_.b;
    if (slope > 0) outcome_.flattest = std::min(outcome_.flattest, slope);
  }

  /// Whether sliding can press the bodies together: u_n decreases in some direction of slip. |k| ≤ |k1| + |k2| decides
  /// most cases without a root; half of b is far from rounding.
  static bool may_jam(const Impact& i) {
    if (i.mu * (std::abs(i.k1) + std::abs(i.k2)) < i.b / 2) return false;
    return std::isfinite(i.mu) && i.mu * std::sqrt(i.k1 * i.k1 + i.k2 * i.k2) > i.b;
  }

  bool approaches_again() {
    if (!jams_) return false;
    const double u = normal_speed(i_, at_);
    if (i_.e > 0) closest_miss_ = std::min(closest_miss_, std::abs(u));
    const double terms = std::abs(i_.k1 * at_.P1) + std::abs(i_.k2 * at_.P2) + i_.b * at_.p;
    if (!(u < -noise * std::max(speeds_, terms)) || ++compressions_ > most_compressions) return false;
    outcome_.regime.compressed_again = true;
    mark(Mark::impulse_again);
    return true;
  }

  void go(const Goal& goal) {
    while (true) {
      if (i_.mu == 0) {
        go_straight(i_, {0, 0, i_.b, 0}, goal, at_);
        return;
      }
      if (at_.s == 0) {
        outcome_.regime.stopped = true;
        const Restart from = restart(i_);
        if (!from.sticks) {
          outcome_.regime.slid_off = true;
          mark(Mark::impulse_slide_off);
          at_.c = from.c;
          at_.d = from.d;
        }
        go_straight(i_, from.line, goal, at_);
        return;
      }
      if (is_straight(i_, at_)) {
        if (go_straight(i_, sliding(i_, at_.c, at_.d), goal, at_) == Reached::goal) return;
      } else {
        outcome_.regime.curved = true;
        if (go_round(i_, goal, at_, closest_miss_) == CurveEnd::goal) return;
      }
    }
  }

  /// A choice that ends the loop: one more was enough in all cases seen so far.
  static constexpr int most_compressions = 16;

  Impact i_;
  double speeds_;
  bool jams_;
  ImpactState at_;
  Outcome outcome_;
  double closest_miss_ = 1e300;
  int compressions_ = 0;
};

double power_of_two(double x) {
  int exponent = 0;
  std::frexp(x, &exponent);
  return std::ldexp(1.0, std::clamp(exponent, -1000, 1000));
}

/// Outside this range squares overflow or lose bits.
bool is_moderate(double x) { return 0x1p-200 < x && x < 0x1p200; }

}  // namespace

Outcome solve(const Impact& impact) {
  const double u = std::max({std::abs(impact.u1), std::abs(impact.u2), std::abs(impact.un)});
  const double K = std::max({impact.l1, impact.l2, impact.b});
  if (is_moderate(u) && is_moderate(K)) return ImpactSolver(impact).run();
  if (u == 0) return {};
  mark(Mark::impulse_scaled);
  const double a = power_of_two(u), b = power_of_two(K);
  Impact scaled = impact;
  for (double* x : {&scaled.u1, &scaled.u2, &scaled.un}) *x /= a;
  for (double* x : {&scaled.l1, &scaled.l2, &scaled.k1, &scaled.k2, &scaled.b}) *x /= b;
  Outcome outcome = ImpactSolver(scaled).run();
  for (double* x : {&outcome.P1, &outcome.P2, &outcome.p, &outcome.compression}) *x = *x / b * a;
  return outcome;
}

double error_bound(double condition) { return condition <= 10 ? 256 * u : 1024 * u * condition; }

}  // namespace touchstone::fast::impulse
