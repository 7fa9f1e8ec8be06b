#include "reference/impulse/slide.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "reference/impulse/lines.h"

namespace touchstone::reference {
namespace {

/// The length of the series of a number type: about the number of terms with the least cost (Jorba and Zou 2005: half
/// of bits_kept · ln 2).
template <class T>
struct Places;

template <>
struct Places<Float> {
  static constexpr int bits = 250;       ///< that are trusted in a result
  static constexpr int bits_kept = 165;  ///< accuracy of a cut series, relative to its first term
  static constexpr std::size_t order = 56;
  static constexpr std::size_t terms_to_stop = 64;
};

template <>
struct Places<DoubleDouble> {
  static constexpr int bits = 100;
  static constexpr int bits_kept = 84;
  static constexpr std::size_t order = 29;
  static constexpr std::size_t terms_to_stop = 40;
};

/// Any unit vector perpendicular to n.
template <class T>
Three<T> across(const Three<T>& n) {
  std::size_t least = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (abs(n[i]) < abs(n[least])) least = i;
  }
  Three<T> axis{};
  axis[least] = 1;
  const Three<T> t = cross(n, axis);
  return scaled(T(1 / sqrt(inner(t, t))), t);
}

/// Power series in τ up to `order`.
template <class T>
using Series = std::array<T, Places<T>::order + 1>;

template <class T>
struct SlipSeries {
  Series<T> x, y, s, p, D;
};

template <class T>
T product(const Series<T>& a, const Series<T>& b, std::size_t n) {
  T sum = 0;
  for (std::size_t i = 0; i <= n; ++i) sum += a[i] * b[n - i];
  return sum;
}

template <class T>
T square(const Series<T>& a, std::size_t n) {
  T half = 0;
  for (std::size_t i = 0; 2 * i < n; ++i) half += a[i] * a[n - i];
  return n % 2 == 0 ? T(2 * half + a[n / 2] * a[n / 2]) : T(2 * half);
}

template <class T>
SlipSeries<T> series(const Tangent<T>& t, const Slip<T>& start) {
  SlipSeries<T> c;
  Series<T> h, g;
  c.x[0] = start.x;
  c.y[0] = start.y;
  c.s[0] = start.s;
  c.p[0] = start.p;
  c.D[0] = start.D;
  const T turn = t.mu * (t.l1 - t.l2);
  for (std::size_t n = 0; n < Places<T>::order; ++n) {
    h[n] = t.k2 * c.x[n] - t.k1 * c.y[n] + turn * product(c.x, c.y, n);
    g[n] = t.k1 * c.x[n] + t.k2 * c.y[n] - turn * square(c.x, n);
    if (n == 0) g[n] -= t.mu * t.l2;
    const auto next = static_cast<int>(n + 1);
    c.x[n + 1] = -product(h, c.y, n) / next;
    c.y[n + 1] = product(h, c.x, n) / next;
    c.s[n + 1] = product(g, c.s, n) / next;
    c.p[n + 1] = c.s[n] / next;
    c.D[n + 1] = square(c.s, n) / next;
  }
  return c;
}

/// log2 |x|, at most 0.09 too small: computed from the leading bits, where that is enough.
double log2_of(const Float& x) {
  long exponent = 0;
  const double mantissa = std::abs(mpfr_get_d_2exp(&exponent, x.backend().data(), MPFR_RNDN));
  return static_cast<double>(exponent) + 2 * (mantissa - 1);
}
double log2_of(const DoubleDouble& x) {
  int exponent = 0;
  const double mantissa = std::abs(std::frexp(x.hi, &exponent));
  return exponent + 2 * (mantissa - 1);
}

/// log2 of the τ at which |c_n| τⁿ has fallen to 2^-bits_kept of `scale` (Jorba & Zou 2005). Their safety factor is
/// left out: two terms are tested, and bits_kept is well above the stated accuracy.
template <class T>
void limit_by(double& log2_tau, const T& c_n, std::size_t n, double log2_scale) {
  if (c_n == 0) return;
  const double found = (log2_scale - Places<T>::bits_kept - log2_of(c_n)) / static_cast<double>(n);
  if (found < log2_tau) log2_tau = found;
}

/// 2^x, at most 6 % too large.
template <class T>
T about_power_of_two(double x) {
  const double whole = std::floor(x);
  return ldexp(T(1 + (x - whole)), static_cast<int>(whole));
}

template <class T>
T step_size(const SlipSeries<T>& c) {
  constexpr double slowest = 1e6;  // an exponent: nothing varies
  double log2_tau = slowest;
  const double log2_s = log2_of(c.s[0]);
  for (const std::size_t n : {Places<T>::order - 1, Places<T>::order}) {
    limit_by(log2_tau, c.x[n], n, 0);
    limit_by(log2_tau, c.y[n], n, 0);
    limit_by(log2_tau, c.s[n], n, log2_s);
    limit_by(log2_tau, T(c.D[n] * static_cast<int>(n)), n - 1, 2 * log2_s);  // D' = s² may fall twice as fast
  }
  return log2_tau == slowest ? T(0) : about_power_of_two<T>(log2_tau);
}

template <class T>
T value(const Series<T>& c, const T& tau) {
  T sum = c[Places<T>::order];
  for (std::size_t n = Places<T>::order; n-- > 0;) sum = sum * tau + c[n];
  return sum;
}

template <class T>
Slip<T> at(const SlipSeries<T>& c, const T& tau) {
  return {value(c.x, tau), value(c.y, tau), value(c.s, tau), value(c.p, tau), value(c.D, tau)};
}

/// The zero of a rising function that is ≤ 0 at lo and ≥ 0 at hi, by Newton steps, or bisection where they leave the
/// bracket. f returns value and derivative.
template <class T, class Function>
T zero_between(T lo, T hi, const Function& f) {
  const T close = ldexp(T(hi - lo), 10 - Places<T>::bits);
  T x = (lo + hi) / 2;
  for (int i = 0; i < 600 && hi - lo > close; ++i) {
    const auto [value, derivative] = f(x);
    (value < 0 ? lo : hi) = x;
    if (value == 0) return x;
    T next = derivative > 0 ? T(x - value / derivative) : lo;
    if (!(lo < next && next < hi)) next = (lo + hi) / 2;
    if (abs(next - x) <= close) return next;
    x = next;
  }
  return x;
}

}  // namespace

template <class T>
Tangent<T>::Tangent(const ImpactProblem<T>& problem) : n(problem.N), mu(sqrt(problem.cone)) {
  const Three<T> a1 = across(n);
  const Three<T> a2 = cross(n, a1);
  const T m11 = inner(a1, times(problem.K, a1));
  const T m12 = inner(a1, times(problem.K, a2));
  const T m22 = inner(a2, times(problem.K, a2));
  // Jacobi rotation (Golub & Van Loan 2013, 8.5.2).
  T t = 0;
  if (m12 != 0) {
    const T z = (m22 - m11) / (2 * m12);
    t = (z < 0 ? -1 : 1) / (abs(z) + sqrt(1 + z * z));
  }
  const T c = 1 / sqrt(1 + t * t);
  e1 = minus(scaled(c, a1), scaled(T(t * c), a2));
  e2 = plus(scaled(T(t * c), a1), scaled(c, a2));
  l1 = inner(e1, times(problem.K, e1));
  l2 = inner(e2, times(problem.K, e2));
  const Three<T> Kn = times(problem.K, n);
  k1 = inner(e1, Kn);
  k2 = inner(e2, Kn);
  b = inner(n, Kn);
}

/// q = −(M + λ)⁻¹ k with λ > 0 such that |q| = μ. 1/|q| is concave and rising in λ, so Newton's method for 1/|q| = 1/μ
/// rises from λ = 0 to the root (More & Sorensen 1983).
template <class T>
Three<T> diverging(const ImpactProblem<T>& problem, const Three<T>& sticking) {
  if (problem.facts.rest_turns) return scaled(T(sqrt(problem.cone / inner(sticking, sticking))), sticking);
  const Tangent<T> t(problem);
  T lambda = 0;
  for (int i = 0; i < 400; ++i) {
    const T q1 = t.k1 / (t.l1 + lambda);
    const T q2 = t.k2 / (t.l2 + lambda);
    const T length2 = q1 * q1 + q2 * q2;
    const T step = (sqrt(length2) / t.mu - 1) * length2 / (q1 * q1 / (t.l1 + lambda) + q2 * q2 / (t.l2 + lambda));
    lambda += step;
    if (abs(step) <= ldexp(lambda, -Places<T>::bits)) break;
  }
  const Three<T> q = plus(scaled(T(-t.k1 / (t.l1 + lambda)), t.e1), scaled(T(-t.k2 / (t.l2 + lambda)), t.e2));
  return scaled(T(t.mu / sqrt(inner(q, q))), q);
}

/// A part of a series' range on which U is monotone.
template <class T>
class Piece : public Phase<T> {
 public:
  Piece(const Slide<T>& slide, std::shared_ptr<const SlipSeries<T>> c, const T& from, const T& to, bool peak)
      : slide_(slide), series_(std::move(c)), begin_(impact_state(from)), end_(impact_state(to)), peak_(peak) {}

  const ImpactState<T>& begin() const override { return begin_; }
  const ImpactState<T>* end() const override { return &end_; }

  std::optional<ImpactState<T>> when_p(const T& c, const ImpactState<T>& from) const override {
    if (from.p >= c) return from;
    if (end_.p < c) return {};
    return impact_state(zero_between(from.at, end_.at, [&](const T& tau) {
      return std::pair(T(value(series_->p, tau) - c), value(series_->s, tau));
    }));
  }

  std::optional<ImpactState<T>> when_U(const T& c, const ImpactState<T>& from) const override {
    if (from.U >= c) return from;
    if (end_.U < c) return {};
    return impact_state(zero_between(from.at, end_.at, [&](const T& tau) {
      const Slip<T> slip = at(*series_, tau);
      return std::pair(T(slide_.impact_state(slip).U - c), T(slip.s * slide_.tangent_.rise(slip.x, slip.y)));
    }));
  }

  /// W' = U s: W rises where U > 0, and U changes sign at most once.
  std::optional<ImpactState<T>> when_W(const T& c, const ImpactState<T>& from) const override {
    if (from.W >= c) return from;
    ImpactState<T> lo = from;
    ImpactState<T> hi = end_;
    if (from.U < 0 && end_.U > 0) lo = *when_U(T(0), from);
    const bool has_top = from.U > 0 && end_.U < 0;
    if (has_top) hi = top_of_W(from);  // where U is 0, but for rounding
    if (hi.W < c || (hi.U < 0 && !has_top) || lo.W >= c) return {};
    return impact_state(zero_between(lo.at, hi.at, [&](const T& tau) {
      const ImpactState<T> m = impact_state(tau);
      return std::pair(T(m.W - c), T(m.U * value(series_->s, tau)));
    }));
  }

  T slope(const ImpactState<T>& here) const override {
    const Slip<T> slip = at(*series_, here.at);
    return slide_.tangent_.rise(slip.x, slip.y);
  }

  /// By the parabola approximation: U'² / (2 |U''|), U'' = μ (k1 y − k2 x) h / s.
  std::optional<T> rise_left(const ImpactState<T>& here) const override {
    const Tangent<T>& t = slide_.tangent_;
    const Slip<T> slip = at(*series_, here.at);
    const T rise = t.rise(slip.x, slip.y);
    const T bend = t.mu * (t.k1 * slip.y - t.k2 * slip.x) * t.h(slip.x, slip.y) / slip.s;
    if (rise < 0 || bend >= 0) return {};
    return T(rise * rise / (-2 * bend));
  }

  bool ends_at_peak() const override { return peak_; }

 private:
  ImpactState<T> impact_state(const T& tau) const {
    ImpactState<T> m = slide_.impact_state(at(*series_, tau));
    m.at = tau;
    return m;
  }

  ImpactState<T> top_of_W(const ImpactState<T>& from) const {
    return impact_state(zero_between(from.at, end_.at, [&](const T& tau) {
      const Slip<T> slip = at(*series_, tau);
      return std::pair(T(-slide_.impact_state(slip).U), T(-slip.s * slide_.tangent_.rise(slip.x, slip.y)));
    }));
  }

  const Slide<T>& slide_;
  std::shared_ptr<const SlipSeries<T>> series_;
  ImpactState<T> begin_, end_;
  bool peak_;
};

/// A slip s changes u by s, and so P by at most s √(tr K⁻¹) in the energy norm; the law is continuous at s = 0.
template <class T>
Slide<T>::Slide(const ImpactProblem<T>& problem) : problem_(problem), tangent_(problem) {
  const Square<T>& inverse = problem.K_inverse;
  const T energy = inner(problem.u0, times(inverse, problem.u0));
  negligible_ = ldexp(T(sqrt(energy / (inverse[0][0] + inverse[1][1] + inverse[2][2]))), -Places<T>::bits_kept - 10);
  const T x = inner(tangent_.e1, problem.u0);
  const T y = inner(tangent_.e2, problem.u0);
  const T s = sqrt(x * x + y * y);
  first_ = now_ = {T(x / s), T(y / s), s, T(0), T(0)};
}

/// u_t = s (x, y) gives P_t, P gives u, and the change of energy gives W.
template <class T>
ImpactState<T> Slide<T>::impact_state(const Slip<T>& slip) const {
  const Tangent<T>& t = tangent_;
  ImpactState<T> m;
  m.p = slip.p;
  const T P1 = (slip.s * slip.x - first_.s * first_.x - t.k1 * slip.p) / t.l1;
  const T P2 = (slip.s * slip.y - first_.s * first_.y - t.k2 * slip.p) / t.l2;
  m.P = plus(scaled(slip.p, t.n), plus(scaled(P1, t.e1), scaled(P2, t.e2)));
  m.u = plus(problem_.u0, times(problem_.K, m.P));
  m.U = inner(m.u, t.n);
  m.W = inner(plus(problem_.u0, m.u), m.P) / 2 + t.mu * slip.D;
  return m;
}

namespace {

/// A direction to which slip turns and in which it decreases: h = 0, h' < 0, g < 0 there.
template <class T>
struct Converging {
  T x, y;
  T g;
  T delta;  ///< the angle of the present slip, measured from (x, y)
};

template <class T>
T slope_of_h(const Tangent<T>& t, const T& x, const T& y) {
  return -(t.k1 * x + t.k2 * y) + t.mu * (t.l1 - t.l2) * (x * x - y * y);
}

/// The angle with this small sine: 2 atan(t) = 2 (t − t³/3 + t⁵/5 − …), t the tangent of half the angle.
template <class T>
T angle(const T& sine) {
  const T t = sine / (1 + sqrt(T(1 - sine * sine)));
  T sum = 0;
  T power = t;
  for (int n = 1; abs(power) > ldexp(abs(t), -Places<T>::bits); n += 2) {
    sum += power / n;
    power *= -(t * t);
  }
  return 2 * sum;
}

/// Newton's method. None unless Kantorovich's condition h |h''| ≤ h'²/8 proves that there is such a direction nearby.
template <class T>
std::optional<Converging<T>> converging(const Tangent<T>& t, const Slip<T>& slip) {
  T x = slip.x;
  T y = slip.y;
  const T bend = sqrt(t.k1 * t.k1 + t.k2 * t.k2) + 2 * t.mu * abs(t.l1 - t.l2);
  const T slope = slope_of_h(t, x, y);
  if (slope >= 0 || abs(t.h(x, y)) * bend * 8 > slope * slope) return {};
  for (int i = 0; i < 12; ++i) {
    const T turn = -t.h(x, y) / slope_of_h(t, x, y);
    const T turned_x = x - turn * y;
    const T turned_y = y + turn * x;
    const T length = sqrt(turned_x * turned_x + turned_y * turned_y);
    x = turned_x / length;
    y = turned_y / length;
    if (abs(turn) < ldexp(T(1), -(Places<T>::bits + 30) / 2)) break;  // the next turn would be below the last bit
  }
  return Converging<T>{x, y, t.g(x, y), angle(T(x * slip.y - y * slip.x))};
}

/// h and g near a direction, as power series in the angle d from it.
template <class T>
struct Around {
  std::vector<T> h, g;
};

template <class T>
Around<T> around(const Tangent<T>& t, const Converging<T>& to, std::size_t terms) {
  const T kc = t.k1 * to.x + t.k2 * to.y;
  const T ks = t.k2 * to.x - t.k1 * to.y;
  const T m = t.mu * (t.l1 - t.l2) / 2;
  const T s2 = 2 * to.x * to.y;
  const T c2 = to.x * to.x - to.y * to.y;
  Around<T> result;
  T one = 1;  // 1/n!
  T two = 1;  // 2ⁿ/n!
  for (std::size_t n = 0; n < terms; ++n) {
    const bool odd = n % 2 != 0;
    const int sign = n % 4 < 2 ? 1 : -1;  // sign of cos at 0, 2, 4, … and of sin at 1, 3, 5, …
    result.h.push_back(sign * (odd ? T(-kc * one + m * c2 * two) : T(ks * one + m * s2 * two)));
    result.g.push_back(sign * (odd ? T(ks * one + m * s2 * two) : T(kc * one - m * c2 * two)));
    one /= static_cast<int>(n + 1);
    two *= 2;
    two /= static_cast<int>(n + 1);
  }
  result.g[0] -= t.mu * (t.l1 + t.l2) / 2;
  return result;
}

/// F(delta) for the solution of h F' + c g F = −1 that is analytic at 0: sᶜ F is the rest of ∫ sᶜ dτ until slip stops.
///   (n h1 + c g0) F_n = −[n = 0] − Σ_{j≥2} h_j (n − j + 1) F_{n−j+1} − c Σ_{j≥1} g_j F_{n−j}
/// As h1, g0 < 0, there is no resonance. None if the series has not converged. Small terms alone do not show
/// convergence, since the first few may be 0 by chance (g0 = h1/2 and no even part: F_1 = F_2 = F_3 = 0).
template <class T>
std::optional<T> remaining(const Around<T>& a, int c, const T& delta) {
  std::vector<T> F;
  T sum = 0;
  T power = 1;
  int small = 0;
  for (std::size_t n = 0; n < a.h.size(); ++n) {
    T rest = n == 0 ? -1 : 0;
    for (std::size_t j = 2; j <= n; ++j) rest -= a.h[j] * static_cast<int>(n - j + 1) * F[n - j + 1];
    for (std::size_t j = 1; j <= n; ++j) rest -= c * a.g[j] * F[n - j];
    F.push_back(rest / (static_cast<int>(n) * a.h[1] + c * a.g[0]));
    const T term = F[n] * power;
    sum += term;
    power *= delta;
    if (n == 16 && abs(term) > ldexp(abs(sum), -45)) return {};  // converges too slowly
    small = abs(term) <= ldexp(abs(sum), -Places<T>::bits_kept - 10) ? small + 1 : 0;
    if (small >= 3 && abs(power) <= ldexp(T(1), -Places<T>::bits_kept)) return sum;
  }
  return {};
}

/// True if dU/dp has no zero between two directions less than a half turn apart: it is monotone where k × σ keeps its
/// sign.
template <class T>
bool monotone(const Tangent<T>& t, const Slip<T>& a, const Slip<T>& b) {
  if (t.mu * t.mu * (t.k1 * t.k1 + t.k2 * t.k2) <= t.b * t.b) return true;
  const auto side = [&](const Slip<T>& s) { return T(t.k1 * s.y - t.k2 * s.x); };
  return side(a) * side(b) >= 0 && t.rise(a.x, a.y) * t.rise(b.x, b.y) >= 0;
}

}  // namespace

/// Finds the direction that slip approaches, and where slip will stop, if it does.
template <class T>
void Slide<T>::foresee() {
  const auto to = converging(tangent_, now_);
  if (!to) return;
  // A series that is cut at 2^-bits_kept may leave the direction somewhat farther away than that, in each step again.
  // The accuracy that is stated leaves room for 2^4 times as much.
  const T off = abs(to->delta), cut = ldexp(T(1), -Places<T>::bits_kept);
  settled_ = off <= cut || (off >= off_before_ && off <= 16 * cut);
  off_before_ = off;
  if (stop_ || to->g >= 0) return;
  // If g is nearly 0 (perhaps exactly 0, but for rounding), slip stops so late, if ever, that p and W would lose their
  // digits by cancellation.
  const Tangent<T>& t = tangent_;
  if (-to->g <= ldexp(T(abs(t.k1) + abs(t.k2) + t.mu * (t.l1 + t.l2)), -Places<T>::bits / 2)) return;
  const Around<T> a = around(tangent_, *to, Places<T>::terms_to_stop);
  const auto rest_of_p = remaining(a, 1, to->delta);
  const auto rest_of_D = remaining(a, 2, to->delta);
  if (!rest_of_p || !rest_of_D) return;
  stop_ = {to->x, to->y, T(0), T(now_.p + now_.s * *rest_of_p), T(now_.D + now_.s * now_.s * *rest_of_D)};
}

/// Slip whose direction no longer changes: until it stops, or without end.
template <class T>
std::unique_ptr<Phase<T>> Slide<T>::straight() {
  const Tangent<T>& t = tangent_;
  const Three<T> slip = plus(scaled(now_.x, t.e1), scaled(now_.y, t.e2));
  const Three<T> zeta = minus(t.n, scaled(t.mu, slip));
  if (!stop_) return std::make_unique<Ray<T>>(problem_, impact_state(now_), zeta);
  stopped_ = stop_->p;
  return std::make_unique<Ray<T>>(problem_, impact_state(now_), zeta, T(stop_->p - now_.p));
}

/// Skips the rest of slip up to its stop. Null if compression or restitution may end before.
template <class T>
std::unique_ptr<Phase<T>> Slide<T>::skipped_phase(const ImpactProgress<T>& progress) {
  const ImpactState<T> from = impact_state(now_);
  const ImpactState<T> end = impact_state(*stop_);
  if (!monotone(tangent_, now_, *stop_) || !progress.quiet(from, end)) return nullptr;
  stopped_ = stop_->p;
  return std::make_unique<SkippedPhase<T>>(from, end);
}

/// One series, cut where U has an extremum.
template <class T>
void Slide<T>::step() {
  const auto c = std::make_shared<const SlipSeries<T>>(series(tangent_, now_));
  const T whole = step_size(*c);
  std::vector<T> cuts = {T(0), whole};
  const auto cut_where = [&](const auto& f) {
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      const T a = f(at(*c, cuts[i - 1]));
      const T b = f(at(*c, cuts[i]));
      if (a * b >= 0) continue;
      const int sign = a < 0 ? 1 : -1;
      const T cut =
          zero_between(cuts[i - 1], cuts[i], [&](const T& tau) { return std::pair(T(sign * f(at(*c, tau))), T(0)); });
      cuts.insert(cuts.begin() + static_cast<std::ptrdiff_t>(i++), cut);
    }
  };
  const Tangent<T>& t = tangent_;
  if (!(t.mu * t.mu * (t.k1 * t.k1 + t.k2 * t.k2) <= t.b * t.b)) {
    cut_where([&](const Slip<T>& s) { return T(t.k1 * s.y - t.k2 * s.x); });
    cut_where([&](const Slip<T>& s) { return t.rise(s.x, s.y); });
  }
  const auto rises = [&](std::size_t i) {
    const Slip<T> middle = at(*c, (cuts[i] + cuts[i + 1]) / 2);
    return t.rise(middle.x, middle.y) > 0;
  };
  for (std::size_t i = cuts.size() - 1; i-- > 0;) {
    const bool peak = i + 2 < cuts.size() && rises(i) && !rises(i + 1);
    pieces_.push_back(std::make_unique<Piece<T>>(*this, c, cuts[i], cuts[i + 1], peak));
  }
  now_ = at(*c, whole);
  const T length = sqrt(now_.x * now_.x + now_.y * now_.y);  // removes rounding errors
  now_.x /= length;
  now_.y /= length;
}

template <class T>
std::unique_ptr<Phase<T>> Slide<T>::next(const ImpactProgress<T>& progress) {
  if (pieces_.empty()) {
    if (!stopped_ && now_.s <= negligible_) stopped_ = now_.p;
    if (stopped_) return rest(problem_, progress.now());
    foresee();
    if (stop_) {
      if (auto last = skipped_phase(progress)) return last;
    }
    if (settled_) return straight();
    step();
  }
  auto piece = std::move(pieces_.back());
  pieces_.pop_back();
  return piece;
}

template Three<Float> diverging(const ImpactProblem<Float>&, const Three<Float>&);
template Three<DoubleDouble> diverging(const ImpactProblem<DoubleDouble>&, const Three<DoubleDouble>&);
template class Slide<Float>;
template class Slide<DoubleDouble>;

}  // namespace touchstone::reference
