#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/linear_impl.h"
#include "reference/tumble_impl.h"

namespace touchstone::reference {
namespace {

using E = WideEnclosure;
using Vec = Coordinates<E>;

Vec times(const std::array<Vec, 3>& M, const Vec& v) { return {dot(M[0], v), dot(M[1], v), dot(M[2], v)}; }

Vec angular(const std::array<E, 7>& y) { return {y[4], y[5], y[6]}; }

constexpr long no_exponent = -100000;

/// Horner's rule.
template <class T, std::size_t n>
std::array<T, 7> sum_of(const std::array<std::array<T, 7>, n>& c, const T& s) {
  std::array<T, 7> y = c[n - 1];
  for (std::size_t k = n - 1; k-- > 0;) {
    for (std::size_t i = 0; i < 7; ++i) y[i] = y[i] * s + c[k][i];
  }
  return y;
}

template <class T>
std::array<T, 7> anything() {
  using P = decltype(lower(T()));
  const P infinite = std::numeric_limits<P>::infinity();
  std::array<T, 7> y;
  y.fill(between(P(-infinite), infinite));
  return y;
}

/// About 2^(quarters/4), in the same bits everywhere.
Float power_of_two(long quarters) {
  static constexpr std::array<double, 4> fractions = {1, 1.1892, 1.4142, 1.6817};
  const long whole = quarters >= 0 ? quarters / 4 : -((3 - quarters) / 4);
  return ldexp(Float(fractions[static_cast<std::size_t>(quarters - 4 * whole)]), static_cast<int>(whole));
}

/// The e with 2^(e − 1) ≤ |x| < 2^e at the end that is farther from 0.
long exponent(const E& x) {
  const Float greatest = std::max(abs(lower(x)), abs(upper(x)));
  return greatest == 0 ? no_exponent : static_cast<long>(mpfr_get_exp(greatest.backend().data()));
}

}  // namespace

Tumble::Tumble(const std::array<std::array<mpq_class, 3>, 3>& I_B, const std::array<mpq_class, 4>& q,
               const std::array<mpq_class, 3>& w_B) {
  const std::array<std::array<mpq_class, 3>, 3> inverse = inverted(I_B);
  for (std::size_t i = 0; i < 3; ++i) {
    I_[i] = enclosed<E>(I_B[i]);
    I_inverse_[i] = enclosed<E>(inverse[i]);
    now_[4 + i] = enclosed<E>(w_B[i]);
  }
  for (std::size_t i = 0; i < 4; ++i) now_[i] = enclosed<E>(q[i]);
}

Tumble::State Tumble::derivative(const State& y) const {
  const Vec w = angular(y);
  const Rotor<E> q = Rotor<E>{y[0], y[1], y[2], y[3]} * Rotor<E>{E(0), w.x, w.y, w.z};
  const Vec alpha = times(I_inverse_, cross(times(I_, w), w));
  return {E(q[0] / 2), E(q[1] / 2), E(q[2] / 2), E(q[3] / 2), alpha.x, alpha.y, alpha.z};
}

/// By the products of series: (k + 1) y_(k+1) is the k-th coefficient of the right side.
Tumble::Series<E> Tumble::series(const State& y) const {
  Series<E> c;
  c[0] = y;
  std::array<Vec, degree + 1> L;
  for (std::size_t k = 0; k < degree; ++k) {
    L[k] = times(I_, angular(c[k]));
    Rotor<E> qw = {E(0), E(0), E(0), E(0)};
    Vec Lw = {E(0), E(0), E(0)};
    for (std::size_t j = 0; j <= k; ++j) {
      const Vec w = angular(c[k - j]);
      const Rotor<E> term = Rotor<E>{c[j][0], c[j][1], c[j][2], c[j][3]} * Rotor<E>{E(0), w.x, w.y, w.z};
      for (std::size_t i = 0; i < 4; ++i) qw[i] += term[i];
      Lw = Lw + cross(L[j], w);
    }
    const E next(static_cast<int>(k + 1));
    const Vec alpha = times(I_inverse_, Lw);
    for (std::size_t i = 0; i < 4; ++i) c[k + 1][i] = qw[i] / (2 * next);
    c[k + 1][4] = alpha.x / next;
    c[k + 1][5] = alpha.y / next;
    c[k + 1][6] = alpha.z / next;
  }
  return c;
}

/// So long a step that the last term is 2^-96 of the first, by the last two of q and of ω.
Float Tumble::stride(const Series<E>& c) {
  constexpr long digits = 96;
  long quarters = 4000;
  for (const auto& [first, last] : {std::pair<std::size_t, std::size_t>{0, 4}, {4, 7}}) {
    const auto size = [&, from = first, to = last](std::size_t k) {
      long greatest = no_exponent;
      for (std::size_t i = from; i < to; ++i) greatest = std::max(greatest, exponent(c[k][i]));
      return greatest;
    };
    for (const std::size_t k : {degree - 1, degree}) {
      quarters = std::min(quarters, 4 * (size(0) - size(k) - digits) / static_cast<long>(k));
    }
  }
  return power_of_two(quarters);
}

/// y and all that comes within h of it, if a box around it twice as large as the first derivative wants is large
/// enough.
std::optional<Tumble::State> Tumble::tube(const State& y, const Float& h) const {
  const State slope = derivative(y);
  Float fastest_q = 0, fastest_w = 0;
  for (std::size_t i = 0; i < 7; ++i) {
    Float& fastest = i < 4 ? fastest_q : fastest_w;
    fastest = std::max({fastest, Float(abs(lower(slope[i]))), Float(abs(upper(slope[i])))});
  }
  State box, reached;
  for (std::size_t i = 0; i < 7; ++i) {
    const Float reach = 2 * h * (i < 4 ? fastest_q : fastest_w);
    box[i] = y[i] + between(Float(-reach), reach);
  }
  const State f = derivative(box);
  for (std::size_t i = 0; i < 7; ++i) {
    reached[i] = y[i] + between(Float(0), h) * f[i];
    if (lower(reached[i]) < lower(box[i]) || upper(reached[i]) > upper(box[i])) return std::nullopt;
  }
  return reached;
}

void Tumble::extend() {
  Step step;
  step.begin = steps_.empty() ? Float(0) : steps_.back().end();
  step.wide = series(now_);
  step.validated = stride(step.wide);
  std::optional<State> reached = tube(now_, step.validated);
  for (; !reached; reached = tube(now_, step.validated)) step.validated /= 2;
  step.wide[degree] = series(*reached)[degree];  // by Lagrange
  const Vec w = angular(*reached);
  const Vec alpha = angular(derivative(*reached));
  step.turning = dot(w, w) + length(alpha);
  for (std::size_t k = 0; k <= degree; ++k) {
    for (std::size_t i = 0; i < 7; ++i) {
      step.narrow[k][i] = converted<Enclosure>(step.wide[k][i]);
    }
  }
  now_ = sum_of(step.wide, thin(Float(step.end() - step.begin)));
  steps_.push_back(std::move(step));
}

/// Requires τ ≥ 0.
const Tumble::Step* Tumble::step_at(const Float& tau) {
  while (steps_.empty() || tau >= steps_.back().end()) {
    if (steps_.size() == most_steps) return nullptr;
    extend();
  }
  const auto after = std::upper_bound(steps_.begin(), steps_.end(), tau,
                                      [](const Float& t, const Step& step) { return t < step.begin; });
  return &*std::prev(after);
}

template <class T>
Tumble::At<T> Tumble::sum(const T& tau, Series<T> Step::*series) {
  const Step* step = step_at(Float(lower(tau)));
  std::array<T, 7> y = anything<T>();
  if (step != nullptr && Float(upper(tau)) <= step->begin + step->validated) {
    y = sum_of(step->*series, T(tau - converted<T>(thin(step->begin))));
  }
  return {{y[0], y[1], y[2], y[3]}, {y[4], y[5], y[6]}};
}

Tumble::At<Enclosure> Tumble::at(const Enclosure& tau) { return sum(tau, &Step::narrow); }
Tumble::At<WideEnclosure> Tumble::at(const WideEnclosure& tau) { return sum(tau, &Step::wide); }

Tumble::Bound Tumble::bound(const Float& tau) {
  const Step* step = step_at(tau);
  if (step == nullptr) return {WideEnclosure(0), tau};
  return {step->turning, step->begin + step->validated};
}

}  // namespace touchstone::reference
