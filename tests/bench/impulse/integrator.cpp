#include "tests/bench/impulse/integrator.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fast/impulse/restart.h"
#include "fast/impulse/straight.h"

namespace touchstone::bench {
namespace {

using namespace fast::impulse;

using Impulse3 = std::array<double, 3>;  // P1, P2, p

Impulse3 plus(const Impulse3& P, double x, const Impulse3& rate) {
  return {P[0] + x * rate[0], P[1] + x * rate[1], P[2] + x * rate[2]};
}

struct Slip {
  double x, y, size;
};

Slip slip_at(const Impact& i, const Impulse3& P) {
  const double x = i.u1 + i.l1 * P[0] + i.k1 * P[2], y = i.u2 + i.l2 * P[1] + i.k2 * P[2];
  return {x, y, std::sqrt(x * x + y * y)};
}

double normal_speed(const Impact& i, const Impulse3& P) { return i.un + i.k1 * P[0] + i.k2 * P[1] + i.b * P[2]; }

/// dP/dp and dP/dtau.
Impulse3 rate_in_p(const Impact& i, const Impulse3& P) {
  const Slip u = slip_at(i, P);
  if (u.size == 0) return {0, 0, 1};
  return {-i.mu * u.x / u.size, -i.mu * u.y / u.size, 1};
}
Impulse3 rate_in_tau(const Impact& i, const Impulse3& P) {
  const Slip u = slip_at(i, P);
  return {-i.mu * u.x, -i.mu * u.y, u.size};
}

using Rate = Impulse3 (*)(const Impact&, const Impulse3&);

double speeds(const Impact& i) { return std::abs(i.u1) + std::abs(i.u2) + std::abs(i.un); }

struct Trial {
  Impulse3 next;
  double error = 0;  ///< m/s; 0 for a fixed step
};

using Step = Trial (*)(const Impact&, const Impulse3&, double);

Trial euler(const Impact& i, const Impulse3& P, double x) { return {plus(P, x, rate_in_p(i, P)), 0}; }

Trial runge_kutta(const Impact& i, const Impulse3& P, double x) {
  const Impulse3 a = rate_in_p(i, P), b = rate_in_p(i, plus(P, x / 2, a)), c = rate_in_p(i, plus(P, x / 2, b)),
                 d = rate_in_p(i, plus(P, x, c));
  Impulse3 next = P;
  for (std::size_t k = 0; k < 3; ++k) next[k] += x / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
  return {next, 0};
}

/// Dormand & Prince 1980, "A family of embedded Runge-Kutta formulae": order 5, error estimate of order 4.
template <Rate rate>
Trial dormand_prince(const Impact& i, const Impulse3& P, double x) {
  static constexpr double a[6][6] = {{1.0 / 5, 0, 0, 0, 0, 0},
                                     {3.0 / 40, 9.0 / 40, 0, 0, 0, 0},
                                     {44.0 / 45, -56.0 / 15, 32.0 / 9, 0, 0, 0},
                                     {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729, 0, 0},
                                     {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656, 0},
                                     {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
  static constexpr double difference[7] = {71.0 / 57600,      0,          -71.0 / 16695, 71.0 / 1920,
                                           -17253.0 / 339200, 22.0 / 525, -1.0 / 40};
  std::array<Impulse3, 7> stage{rate(i, P)};
  Impulse3 at{};
  for (std::size_t s = 0; s < 6; ++s) {
    at = P;
    for (std::size_t j = 0; j <= s; ++j) at = plus(at, x * a[s][j], stage[j]);
    stage[s + 1] = rate(i, at);
  }
  Impulse3 off{};
  for (std::size_t s = 0; s < 7; ++s) off = plus(off, x * difference[s], stage[s]);
  const double size = std::sqrt(i.l1 * off[0] * off[0] + i.l2 * off[1] * off[1] + i.b * off[2] * off[2]);
  return {at, size * std::sqrt(std::max({i.l1, i.l2, i.b}))};
}

struct Method {
  Step step;
  double first = 0;          ///< initial step
  double allowed = 0;        ///< error per step, m/s; 0: fixed steps
  double stopped_below = 0;  ///< slip, m/s, below which its direction is noise and adaptive steps would shrink forever
};

constexpr int most_steps = 200000;

class Integration {
 public:
  Integration(const Impact& impact, const Method& method) : i_(impact), method_(method), x_(method.first) {}

  Outcome run() {
    if (!phase({Goal::Of::speed, 0})) return {NAN, NAN, NAN, NAN, {}, 1};
    const double compression = P_[2];
    if (i_.e > 0 && !phase({Goal::Of::impulse, (1 + i_.e) * compression})) return {NAN, NAN, NAN, NAN, {}, 1};
    return {P_[0], P_[1], P_[2], compression, {}, 1};
  }

 private:
  double off(const Goal& goal, const Impulse3& at) const {
    return goal.of == Goal::Of::impulse ? at[2] - goal.value : normal_speed(i_, at) - goal.value;
  }

  bool phase(const Goal& goal) {
    stopped_ = stopped_ || slip_at(i_, P_).size <= method_.stopped_below;
    while (!stopped_) {
      if (++steps_ > most_steps) return false;
      const Trial trial = method_.step(i_, P_, x_);
      if (trial.error > method_.allowed) {
        resize(trial.error);
        continue;
      }
      if (off(goal, trial.next) >= 0) {
        P_ = meeting(goal, trial.next);
        return true;
      }
      const Slip before = slip_at(i_, P_), after = slip_at(i_, trial.next);
      P_ = trial.next;
      stopped_ = after.size <= method_.stopped_below || before.x * after.x + before.y * after.y <= 0;
      if (method_.allowed > 0) resize(trial.error);
    }
    const Restart from = restart(i_);
    ImpactState at{0, from.c, from.d, P_[0], P_[1], P_[2], 0};
    go_straight(i_, from.line, goal, at);
    P_ = {at.P1, at.P2, at.p};
    return true;
  }

  void resize(double error) {
    x_ *= std::clamp(0.9 * std::pow(method_.allowed / std::max(error, 1e-300), 0.2), 0.2, 5.0);
  }

  /// Where a step reaches the goal. Fixed steps: by linear interpolation; adaptive steps: by bisection of the step.
  Impulse3 meeting(const Goal& goal, const Impulse3& next) const {
    const double start = off(goal, P_), end = off(goal, next);
    if (method_.allowed == 0) {
      return plus(P_, start / (start - end), {next[0] - P_[0], next[1] - P_[1], next[2] - P_[2]});
    }
    double lo = 0, hi = x_;
    Impulse3 at = next;
    for (int k = 0; k < 60 && std::abs(off(goal, at)) > 0.01 * method_.allowed; ++k) {
      const double middle = lo + (hi - lo) / 2;
      at = method_.step(i_, P_, middle).next;
      (off(goal, at) < 0 ? lo : hi) = middle;
    }
    return at;
  }

  const Impact& i_;
  Method method_;
  double x_;
  Impulse3 P_{};
  bool stopped_ = false;
  int steps_ = 0;
};

template <Step step>
Outcome with_steps(const Impact& i, double steps) {
  return Integration(i, {step, -i.un / i.b / steps, 0, 1e-14 * speeds(i)}).run();
}

template <Rate rate>
Outcome adaptive(const Impact& i, double tolerance) {
  const double allowed = tolerance * speeds(i);
  const double pace = std::max(rate(i, {})[2], 1e-300);  // dp per unit of the parameter
  return Integration(i, {dormand_prince<rate>, -i.un / i.b / 16 / pace, allowed, 20 * allowed}).run();
}

Outcome ours(const Impact& i, double) { return solve(i); }

}  // namespace

std::vector<Integrator> integrators() {
  return {{"fast", "1", ours, 0},
          {"Euler in p", "1", with_steps<euler>, 10},
          {"Euler in p", "2", with_steps<euler>, 100},
          {"Euler in p", "3", with_steps<euler>, 1000},
          {"RK4 in p", "1", with_steps<runge_kutta>, 4},
          {"RK4 in p", "2", with_steps<runge_kutta>, 32},
          {"RK4 in p", "3", with_steps<runge_kutta>, 256},
          {"Dormand-Prince in p", "1", adaptive<rate_in_p>, 1e-4},
          {"Dormand-Prince in p", "2", adaptive<rate_in_p>, 1e-8},
          {"Dormand-Prince in p", "3", adaptive<rate_in_p>, 1e-12},
          {"Dormand-Prince in tau", "1", adaptive<rate_in_tau>, 1e-4},
          {"Dormand-Prince in tau", "2", adaptive<rate_in_tau>, 1e-8},
          {"Dormand-Prince in tau", "3", adaptive<rate_in_tau>, 1e-12}};
}

}  // namespace touchstone::bench
