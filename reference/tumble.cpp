#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/linear_impl.h"
#include "reference/tumble_impl.h"

namespace touchstone::reference {
namespace {

using E = WideEnclosure;

template <class T>
Coordinates<T> times(const std::array<Coordinates<T>, 3>& M, const Coordinates<T>& v) {
  return {dot(M[0], v), dot(M[1], v), dot(M[2], v)};
}

template <class T>
Coordinates<T> angular(const std::array<T, 7>& y) {
  return {y[4], y[5], y[6]};
}

std::array<Enclosure, 7> in_doubles(const std::array<E, 7>& y) {
  std::array<Enclosure, 7> narrow;
  for (std::size_t i = 0; i < 7; ++i) narrow[i] = converted<Enclosure>(y[i]);
  return narrow;
}

std::array<E, 7> wide(const std::array<Enclosure, 7>& y) {
  std::array<E, 7> result;
  for (std::size_t i = 0; i < 7; ++i) result[i] = between(Float(y[i].inf()), Float(y[i].sup()));
  return result;
}

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

/// About log2 |x| at the end that is farther from 0.
long exponent(const Enclosure& x) {
  const double greatest = std::max(-x.inf(), x.sup());
  return greatest == 0 ? no_exponent : std::isfinite(greatest) ? std::ilogb(greatest) + 1 : -no_exponent;
}

}  // namespace

Tumble::Tumble(const std::array<std::array<mpq_class, 3>, 3>& I_B, const std::array<mpq_class, 4>& q,
               const std::array<mpq_class, 3>& w_B) {
  const std::array<std::array<mpq_class, 3>, 3> inverse = inverted(I_B);
  for (std::size_t i = 0; i < 3; ++i) {
    wide_.I[i] = enclosed<E>(I_B[i]);
    wide_.I_inverse[i] = enclosed<E>(inverse[i]);
    narrow_.I[i] = enclosed<Enclosure>(I_B[i]);
    narrow_.I_inverse[i] = enclosed<Enclosure>(inverse[i]);
    now_[4 + i] = enclosed<E>(w_B[i]);
  }
  for (std::size_t i = 0; i < 4; ++i) now_[i] = enclosed<E>(q[i]);
}

template <class T>
std::array<T, 7> Tumble::Equations<T>::derivative(const std::array<T, 7>& y) const {
  const Coordinates<T> w = angular(y);
  const Rotor<T> q = Rotor<T>{y[0], y[1], y[2], y[3]} * Rotor<T>{T(0), w.x, w.y, w.z};
  const Coordinates<T> alpha = times(I_inverse, cross(times(I, w), w));
  const T two(2);
  return {T(q[0] / two), T(q[1] / two), T(q[2] / two), T(q[3] / two), alpha.x, alpha.y, alpha.z};
}

/// By the products of series: (k + 1) y_(k+1) is the k-th coefficient of the right side.
template <class T>
void Tumble::Equations<T>::extend(Series<T>& c, std::size_t from, std::size_t to) const {
  std::vector<Coordinates<T>> L, w;
  for (std::size_t k = 0; k < to; ++k) {
    w.push_back(angular(c[k]));
    L.push_back(times(I, w[k]));
    if (k < from) continue;
    Rotor<T> qw = {T(0), T(0), T(0), T(0)};
    Coordinates<T> Lw = {T(0), T(0), T(0)};
    for (std::size_t j = 0; j <= k; ++j) {
      const std::array<T, 7>& q = c[j];
      const Coordinates<T>& v = w[k - j];
      qw[0] -= q[1] * v.x + q[2] * v.y + q[3] * v.z;
      qw[1] += q[0] * v.x + q[2] * v.z - q[3] * v.y;
      qw[2] += q[0] * v.y + q[3] * v.x - q[1] * v.z;
      qw[3] += q[0] * v.z + q[1] * v.y - q[2] * v.x;
      Lw = Lw + cross(L[j], v);
    }
    const T next(static_cast<int>(k + 1));
    const T twice(static_cast<int>(2 * k + 2));
    const Coordinates<T> alpha = times(I_inverse, Lw);
    for (std::size_t i = 0; i < 4; ++i) c[k + 1][i] = qw[i] / twice;
    c[k + 1][4] = alpha.x / next;
    c[k + 1][5] = alpha.y / next;
    c[k + 1][6] = alpha.z / next;
  }
}

/// So long a step that the last term is 2^-100 of the first, by the last two of q and of ω.
Float Tumble::stride(const Series<Enclosure>& c) {
  constexpr long digits = 100;
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
  const State slope = wide_.derivative(y);
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
  const State f = wide_.derivative(box);
  for (std::size_t i = 0; i < 7; ++i) {
    reached[i] = y[i] + between(Float(0), h) * f[i];
    if (!(lower(reached[i]) >= lower(box[i]) && upper(reached[i]) <= upper(box[i]))) return std::nullopt;
  }
  return reached;
}

/// Is the enclosure of q or of ω so wide that it is of no use?
bool Tumble::is_lost() const {
  const auto lost = [&](std::size_t first, std::size_t last) {
    Float size = 0, width = 0;
    for (std::size_t i = first; i < last; ++i) {
      size = greater(size, Float(abs(middle(now_[i]))));
      width = greater(width, Float(upper(now_[i]) - lower(now_[i])));
    }
    return !(width <= size * Float(0x1p-30));
  };
  return lost(0, 4) || lost(4, 7);
}

bool Tumble::extend() {
  if (is_lost()) return false;
  const RoundUpward rounding;
  Step step;
  step.begin = steps_.empty() ? Float(0) : steps_.back().end();
  step.wide[0] = now_;
  wide_.extend(step.wide, 0, wide_orders);
  for (std::size_t k = 0; k <= wide_orders; ++k) step.narrow[k] = in_doubles(step.wide[k]);
  narrow_.extend(step.narrow, wide_orders, degree);
  step.validated = stride(step.narrow);
  std::optional<State> reached = tube(now_, step.validated);
  for (int i = 0; !reached && i < 100; ++i) {
    step.validated /= 2;
    reached = tube(now_, step.validated);
  }
  if (!reached) return false;

  Series<Enclosure> over_tube;
  over_tube[0] = in_doubles(*reached);
  narrow_.extend(over_tube, 0, degree);
  step.narrow[degree] = over_tube[degree];
  for (std::size_t k = wide_orders + 1; k <= degree; ++k) step.wide[k] = wide(step.narrow[k]);
  const Coordinates<E> w = angular(*reached);
  step.turning = dot(w, w) + length(angular(wide_.derivative(*reached)));
  now_ = sum_of(step.wide, thin(Float(step.end() - step.begin)));
  steps_.push_back(std::move(step));
  return true;
}

/// Requires τ ≥ 0.
const Tumble::Step* Tumble::step_at(const Float& tau) {
  while (steps_.empty() || tau >= steps_.back().end()) {
    if (steps_.size() == most_steps || !extend()) return nullptr;
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
