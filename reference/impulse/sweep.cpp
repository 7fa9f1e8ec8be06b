#include "reference/impulse/sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "reference/impulse/lines.h"

namespace touchstone::reference {
namespace {

constexpr std::size_t terms = 96;  ///< of a series; a step is a quarter of ρ, so the remainder is 2^-192
constexpr int most_steps = 400;    ///< each covers at least a ninth of the way to a direction that is never reached
constexpr int close = 176;         ///< states are enclosed within 2^-close of their step

/// |a|, rounded up and rounded down.
Float most(const Enclosed& a) { return std::max(Float(abs(a.lo())), Float(abs(a.hi()))); }
Float least(const Enclosed& a) {
  if (a.holds_zero()) return Float(0);
  return std::min(Float(abs(a.lo())), Float(abs(a.hi())));
}
Enclosed of_size(const Enclosed& a) { return Enclosed(most(a)); }
Enclosed about_zero(const Float& radius) { return {-radius, radius}; }

Enclosed over(const Enclosed& a, std::size_t n) { return a / Enclosed(static_cast<int>(n)); }

Field field(const EnclosedContact& c, const Enclosed& x, const Enclosed& y) {
  const Enclosed m1 = c.m11 * x + c.m12 * y;
  const Enclosed m2 = c.m12 * x + c.m22 * y;
  const Enclosed A = c.mu * (x * m1 + y * m2);
  const Enclosed B = c.mu * (x * m2 - y * m1);
  const Enclosed C = c.mu * (c.m11 * square(y) - 2 * c.m12 * x * y + c.m22 * square(x));
  const Enclosed k = c.k1 * x + c.k2 * y;
  const Enclosed l = c.k2 * x - c.k1 * y;
  Field f;
  f.G = {k - A, 2 * l - 4 * B, 2 * A - 4 * C, 2 * l + 4 * B, -k - A};
  f.H = {l - B, -2 * (k + C - A), 6 * B, -2 * (k - C + A), -l - B};
  for (std::size_t i = 0; i < 7; ++i) {
    if (i < 5) f.qH[i] = f.H[i];
    if (i >= 2) f.qH[i] = f.qH[i] + f.H[i - 2];
  }
  return f;
}

/// Σ_{i ≥ first} |c_i| ρ^(i − first + power), rounded up.
template <class Polynomial>
Enclosed majorant(const Polynomial& c, std::size_t first, int power, const Enclosed& rho) {
  Enclosed sum = 0;
  for (std::size_t i = c.size(); i-- > first;) sum = sum * rho + of_size(c[i]);
  for (; power > 0; --power) sum = sum * rho;
  return sum;
}

/// Σ c_n tⁿ, with |c_n| ≤ bound ρ⁻ⁿ for all n beyond the stored coefficients.
struct PowerSeries {
  std::vector<Enclosed> c;
  Enclosed rho, bound;

  Enclosed at(const Enclosed& t) const {
    Enclosed sum = 0;
    for (std::size_t n = c.size(); n-- > 0;) sum = sum * t + c[n];
    const Enclosed ratio = of_size(t) / rho;
    Enclosed power = 1;
    for (std::size_t n = 0; n < c.size(); ++n) power = power * ratio;
    return sum + about_zero((bound * power / (1 - ratio)).hi());
  }
};

/// The largest n |c_n| ρⁿ among the last `window` terms.
Enclosed last_of(const std::vector<Enclosed>& w, std::size_t window, const Enclosed& rho) {
  Enclosed power = 1;
  Enclosed largest = 0;
  for (std::size_t n = 0; n < w.size(); ++n, power = power * rho) {
    if (n + window >= w.size()) largest = Enclosed(std::max(largest.hi(), (of_size(w[n]) * power).hi()));
  }
  return largest;
}

/// f with q H f' = 2 d G f and f(0) = 1: the slip s to the power d, relative to its start. With w_n = n f_n:
///   H_0 w_{n+1} = 2 d Σ G_j f_{n−j} − Σ_{j≥1} (qH)_j w_{n+1−j}
/// So max |w_m| ρᵐ over six terms does not grow once Σ_{j≥1} |(qH)_j| ρʲ + 2 d/(n − 4) Σ |G_j| ρ^{j+1} ≤ |H_0|.
PowerSeries grown(const Field& f, int d, const Enclosed& rho) {
  const Enclosed inverse = 1 / f.H[0];
  PowerSeries result{{Enclosed(1)}, rho, {}};
  std::vector<Enclosed> w = {Enclosed(0)};
  for (std::size_t n = 0; n < terms; ++n) {
    Enclosed sum = 0;
    for (std::size_t j = 0; j < 5 && j <= n; ++j) sum = sum + f.G[j] * result.c[n - j];
    sum = 2 * d * sum;
    for (std::size_t j = 1; j < 7 && j <= n; ++j) sum = sum - f.qH[j] * w[n + 1 - j];
    w.push_back(sum * inverse);
    result.c.push_back(over(w.back(), n + 1));
  }
  const Enclosed growth = majorant(f.qH, 1, 1, rho) + over(2 * d * majorant(f.G, 0, 1, rho), terms - 4);
  if (growth.hi() > least(f.H[0])) throw Undecided("a series whose end is not bounded");
  result.bound = over(last_of(w, 6, rho), terms + 1);
  return result;
}

/// F with H F' = 2 q f and F(0) = 0. n |F_n| ρⁿ stays below the larger of its last four values and
/// 2 ρ (1 + ρ²) max |f_m| ρᵐ/(|H_0| − Σ_{j≥1} |H_j| ρʲ).
PowerSeries summed(const Field& f, const PowerSeries& of) {
  const Enclosed inverse = 1 / f.H[0];
  PowerSeries result{{Enclosed(0)}, of.rho, {}};
  std::vector<Enclosed> w = {Enclosed(0)};
  for (std::size_t n = 0; n < terms; ++n) {
    Enclosed sum = 2 * (n < 2 ? of.c[n] : of.c[n] + of.c[n - 2]);
    for (std::size_t j = 1; j < 5 && j <= n; ++j) sum = sum - f.H[j] * w[n + 1 - j];
    w.push_back(sum * inverse);
    result.c.push_back(over(w.back(), n + 1));
  }
  const Enclosed left = Enclosed(least(f.H[0])) - majorant(f.H, 1, 1, of.rho);
  if (!left.is_positive()) throw Undecided("a series whose end is not bounded");
  const Enclosed f_bound = Enclosed(std::max(of.bound.hi(), last_of(of.c, 3, of.rho).hi()));
  const Enclosed driven = 2 * of.rho * (1 + square(of.rho)) * f_bound / left;
  result.bound = over(Enclosed(std::max(last_of(w, 4, of.rho).hi(), driven.hi())), terms + 1);
  return result;
}

/// F with q H F' + 2 d G F = −2 q², analytic where H = 0 at t = 0: s^d F is the rest of ∫ s^d dτ until slip stops.
///   (n H_1 + 2 d G_0) F_n = −2 (q²)_n − Σ_{j≥2} (qH)_j (n + 1 − j) F_{n+1−j} − 2 d Σ_{j≥1} G_j F_{n−j}
/// As H_1, G_0 < 0, there is no resonance. max |F_m| ρᵐ over five terms does not grow once
/// Σ_{j≥2} |(qH)_j| ρ^{j−1} + 2 d/n Σ_{j≥1} |G_j| ρʲ ≤ |H_1|.
PowerSeries remaining(const Field& f, int d, const Enclosed& rho) {
  static constexpr std::array q_squared = {1, 0, 2, 0, 1};
  PowerSeries result{{}, rho, {}};
  std::vector<Enclosed> w;
  for (std::size_t n = 0; n <= terms; ++n) {
    Enclosed sum = n < 5 ? -2 * q_squared[n] : 0;
    for (std::size_t j = 2; j < 7 && j <= n; ++j) sum = sum - f.qH[j] * w[n + 1 - j];
    for (std::size_t j = 1; j < 5 && j <= n; ++j) sum = sum - 2 * d * (f.G[j] * result.c[n - j]);
    result.c.push_back(sum / (static_cast<int>(n) * f.H[1] + 2 * d * f.G[0]));
    w.push_back(static_cast<int>(n) * result.c.back());
  }
  const Enclosed growth = majorant(f.qH, 2, 1, rho) + over(2 * d * majorant(f.G, 1, 1, rho), terms);
  if (growth.hi() > least(f.H[1])) throw Undecided("a series whose end is not bounded");
  result.bound = last_of(result.c, 5, rho);
  return result;
}

/// A ρ for which the recurrences do not grow: the largest that fits, in steps of a sixteenth.
template <class Fits>
std::optional<Enclosed> radius(const Fits& fits) {
  double rho = 0.5;
  for (int i = 0; i < 1600; ++i, rho *= 0.9375) {
    if (fits(rho)) return Enclosed(rho);
  }
  return {};
}

double size(const Enclosed& a) { return static_cast<double>(most(a)); }

/// Chooses ρ in doubles; grown() and summed() then prove it. The factor three quarters leaves room for the
/// inhomogeneous terms.
std::optional<Enclosed> radius_of(const Field& f) {
  const auto sum = [](const auto& c, double rho, std::size_t first) {
    double total = 0;
    for (std::size_t i = c.size(); i-- > first;) total = total * rho + size(c[i]);
    return total;
  };
  const double H0 = static_cast<double>(least(f.H[0]));
  return radius([&](double rho) {
    return rho * sum(f.qH, rho, 1) <= 0.75 * H0 &&
           rho * sum(f.qH, rho, 1) + 4 * rho * sum(f.G, rho, 0) / (terms - 4) <= 0.99 * H0;
  });
}

std::optional<Enclosed> radius_at_stop(const Field& f) {
  const auto sum = [](const auto& c, double rho, std::size_t first) {
    double total = 0;
    for (std::size_t i = c.size(); i-- > first;) total = total * rho + size(c[i]);
    return total;
  };
  const double H1 = static_cast<double>(least(f.H[1]));
  return radius([&](double rho) { return rho * sum(f.qH, rho, 2) + 4 * rho * sum(f.G, rho, 1) / terms <= 0.99 * H1; });
}

/// dU/dp times q, a quadratic in t.
struct Rise {
  Enclosed c0, c1, c2;

  Rise(const EnclosedContact& c, const Heading& from) {
    const Enclosed k = c.mu * (c.k1 * from.x + c.k2 * from.y);
    c0 = c.b - k;
    c1 = -2 * c.mu * (c.k2 * from.x - c.k1 * from.y);
    c2 = c.b + k;
  }

  Enclosed at(const Enclosed& t) const { return c0 + t * (c1 + t * c2); }

  /// dU/dp keeps its sign from t = 0 to `end`: it cannot reach 0 so soon; or it has the same sign at both ends, and is
  /// monotone or has no zero at all.
  bool keeps_sign(const Enclosed& end) const {
    if ((of_size(end) * (of_size(c1) + of_size(end) * of_size(c2))).hi() < least(c0)) return true;
    if ((c0 > 0) != (at(end) > 0)) return false;
    return 4 * c0 * c2 > square(c1) || (c1 > 0) == (c1 + 2 * end * c2 > 0);
  }

  /// Approximate distance of its first zero from 0 in the direction `way`; none if there is none.
  std::optional<Float> first_zero(int way) const {
    const Float a = c2.middle();
    const Float b = way * c1.middle();
    const Float c = c0.middle();
    const Float d = b * b - 4 * a * c;
    if (d < 0) return {};
    const Float q = -(b + (b < 0 ? -1 : 1) * sqrt(d)) / 2;
    std::optional<Float> first;
    for (const Float& zero : {Float(q / a), Float(c / q)}) {
      if (zero > 0 && (!first || zero < *first)) first = zero;
    }
    return first;
  }
};

/// The phase from one direction on, as far as a series reaches.
class Arc : public Phase<Enclosed> {
 public:
  /// Requires length ≤ ρ/4.
  Arc(const EnclosedContact& contact, const Heading& from, const Field& f, const Enclosed& rho, const Float& length,
      bool work)
      : contact_(contact),
        from_(from),
        field_(f),
        s_(grown(f, 1, rho)),
        p_(summed(f, s_)),
        way_(f.H[0].is_positive() ? 1 : -1),
        rise_(contact, from),
        length_(length) {
    if (work) D_ = summed(f, grown(f, 2, rho));
    begin_ = impact_state(Enclosed(0));
    end_ = impact_state(length_);
  }

  const ImpactState<Enclosed>& begin() const override { return begin_; }
  const ImpactState<Enclosed>* end() const override { return &end_; }
  Heading heading_at_end() const { return heading(length_); }
  bool keeps_rising_or_falling() const { return !contact_.painleve || rise_.keeps_sign(way_ * length_); }
  bool rises() const { return rise_.c0 > 0; }
  /// An enclosure of all its states.
  ImpactState<Enclosed> whole() const { return impact_state(hull(Enclosed(0), length_)); }

  std::optional<ImpactState<Enclosed>> when_p(const Enclosed& c, const ImpactState<Enclosed>& from) const override {
    return when(c, from, &ImpactState<Enclosed>::p,
                [](const ImpactState<Enclosed>&, const Enclosed&) { return Enclosed(1); });
  }

  std::optional<ImpactState<Enclosed>> when_U(const Enclosed& c, const ImpactState<Enclosed>& from) const override {
    return when(c, from, &ImpactState<Enclosed>::U,
                [](const ImpactState<Enclosed>&, const Enclosed& rising) { return rising; });
  }

  /// W rises where U > 0. Gives up where U falls to 0 first.
  std::optional<ImpactState<Enclosed>> when_W(const Enclosed& c, const ImpactState<Enclosed>& from) const override {
    if (from.U < 0 && end_.U <= 0) return {};
    if (end_.U < 0) throw Undecided("restitution that jams");
    const ImpactState<Enclosed> start = from.U < 0 ? *when_U(Enclosed(0), from) : from;
    return when(c, start, &ImpactState<Enclosed>::W,
                [](const ImpactState<Enclosed>& m, const Enclosed&) { return m.U; });
  }

  Enclosed slope(const ImpactState<Enclosed>& here) const override {
    const Enclosed t = way_ * here.at;
    return rise_.at(t) / (1 + square(t));
  }
  std::optional<Enclosed> rise_left(const ImpactState<Enclosed>& here) const override {
    if (!contact_.painleve) return {};
    const Heading at = heading(here.at);
    const Field f = field(contact_, at.x, at.y);
    const Enclosed rising = slope(here);
    const Enclosed bend = contact_.mu * (contact_.k1 * at.y - contact_.k2 * at.x) * f.H[0] / at.s;
    if (rising < 0 || bend >= 0) return {};
    return square(rising) / (-2 * bend);
  }
  bool ends_at_peak() const override { return false; }

 private:
  /// `far` is |t|.
  Heading heading(const Enclosed& far) const {
    const Enclosed t = way_ * far;
    const Enclosed q = 1 + square(t);
    const Enclosed cosine = (1 - square(t)) / q;
    const Enclosed sine = 2 * t / q;
    Heading h;
    h.x = from_.x * cosine - from_.y * sine;
    h.y = from_.x * sine + from_.y * cosine;
    h.s = from_.s * s_.at(t);
    h.p = from_.p + from_.s * p_.at(t);
    if (D_) h.D = from_.D + square(from_.s) * D_->at(t);
    return h;
  }

  ImpactState<Enclosed> impact_state(const Enclosed& far) const {
    const Heading h = heading(far);
    ImpactState<Enclosed> m = contact_.impact_state(h.s * h.x, h.s * h.y, h.p, h.D);
    m.at = far;
    return m;
  }

  /// The state at which a rising quantity reaches c; `rate` is its derivative with respect to p. Newton steps on the
  /// middles, then bounds on both sides that the enclosures prove.
  template <class Rate>
  std::optional<ImpactState<Enclosed>> when(const Enclosed& c, const ImpactState<Enclosed>& from,
                                            Enclosed ImpactState<Enclosed>::*asked, const Rate& rate) const {
    if (from.*asked >= c) return from;
    if (end_.*asked < c) return {};
    Float lo = from.at.lo();
    Float hi = length_.hi();
    Float x = (lo + hi) / 2;
    for (int i = 0; i < 200; ++i) {
      const ImpactState<Enclosed> m = impact_state(Enclosed(x));
      const Float missing = (c - m.*asked).middle();
      (missing > 0 ? lo : hi) = x;
      const Float steepness = (rate(m, slope(m)) * rate_of_p(Enclosed(x))).middle();
      Float next = steepness > 0 ? Float(x + missing / steepness) : lo;
      if (!(lo < next && next < hi)) next = (lo + hi) / 2;
      const Float step = abs(next - x);
      x = next;
      if (step <= ldexp(length_.hi(), -close - 4)) break;
    }
    for (int wider = 0; wider < 6; ++wider) {
      const Float off = ldexp(length_.hi(), 4 * wider - close);
      const Enclosed before(std::max(Float(x - off), from.at.lo()));
      const Enclosed after(std::min(Float(x + off), length_.lo()));
      if ((impact_state(before).*asked).hi() > c.lo() || (impact_state(after).*asked).lo() < c.hi()) continue;
      ImpactState<Enclosed> found = impact_state(hull(before, after));
      found.*asked = c;
      return found;
    }
    throw Undecided("when a phase of the impact ends");
  }

  /// dp/d|t| = 2 s q/|H|.
  Enclosed rate_of_p(const Enclosed& far) const {
    const Enclosed t = way_ * far;
    Enclosed H = 0;
    for (std::size_t i = 5; i-- > 0;) H = H * t + field_.H[i];
    return way_ * (2 * from_.s * s_.at(t) * (1 + square(t)) / H);
  }

  const EnclosedContact& contact_;
  Heading from_;
  Field field_;
  PowerSeries s_, p_;
  std::optional<PowerSeries> D_;
  int way_;
  Rise rise_;
  Enclosed length_;
  ImpactState<Enclosed> begin_, end_;
};

/// The direction near (x, y) where H = 0 and H' < 0: its middle by Newton steps, then the interval that must contain
/// it.
std::optional<Heading> settling(const EnclosedContact& c, const Heading& now) {
  Enclosed x = now.x;
  Enclosed y = now.y;
  const auto turn = [&](const Enclosed& t) {
    const Enclosed q = 1 + square(t);
    const Enclosed cosine = (1 - square(t)) / q;
    const Enclosed sine = 2 * t / q;
    const Enclosed turned = x * cosine - y * sine;
    y = x * sine + y * cosine;
    x = turned;
  };
  for (int i = 0; i < 12; ++i) {
    const Field f = field(c, x, y);
    if (!f.H[1].is_negative()) return {};
    const Float t = -(f.H[0].middle() / f.H[1].middle());
    if (abs(t) > 0.5) return {};
    turn(Enclosed(t));
    if (abs(t) < ldexp(Float(1), -120)) break;
  }
  // H(t) = H_0 + H'(τ) t: its zero is in −H_0/H'(near), if that lies in `near`.
  const Field f = field(c, x, y);
  const Enclosed near = about_zero(ldexp(Float(1), -200));
  const Enclosed steepness = f.H[1] + near * (2 * f.H[2] + near * (3 * f.H[3] + near * (4 * f.H[4])));
  if (!steepness.is_negative()) return {};
  const Enclosed zero = -f.H[0] / steepness;
  if (zero.lo() < near.lo() || zero.hi() > near.hi()) return {};
  turn(zero);
  return Heading{x, y, Enclosed(0), Enclosed(0), Enclosed(0)};
}

}  // namespace

EnclosedContact::EnclosedContact(const ImpactProblem<Enclosed>& problem)
    : n(problem.N), mu(root(problem.cone)), painleve(problem.facts.painleve) {
  std::size_t smallest = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (most(n[i]) < most(n[smallest])) smallest = i;
  }
  EnclosedVec axis{};
  axis[smallest] = 1;
  const EnclosedVec across = cross(n, axis);
  e1 = scaled(Enclosed(1 / root(inner(across, across))), across);
  e2 = cross(n, e1);
  const EnclosedVec K1 = times(problem.K, e1);
  const EnclosedVec K2 = times(problem.K, e2);
  m11 = inner(e1, K1);
  m12 = inner(e1, K2);
  m22 = inner(e2, K2);
  k1 = inner(n, K1);
  k2 = inner(n, K2);
  b = inner(n, times(problem.K, n));
  u0 = {inner(e1, problem.u0), inner(e2, problem.u0), inner(n, problem.u0)};
}

/// u_t gives P_t, P gives u_n, and the change of energy gives W.
ImpactState<Enclosed> EnclosedContact::impact_state(const Enclosed& u1, const Enclosed& u2, const Enclosed& p,
                                                    const Enclosed& D) const {
  const Enclosed d1 = u1 - u0[0] - k1 * p;
  const Enclosed d2 = u2 - u0[1] - k2 * p;
  const Enclosed det = m11 * m22 - square(m12);
  const Enclosed P1 = (m22 * d1 - m12 * d2) / det;
  const Enclosed P2 = (m11 * d2 - m12 * d1) / det;
  ImpactState<Enclosed> m{};
  m.p = p;
  m.P = plus(scaled(p, n), plus(scaled(P1, e1), scaled(P2, e2)));
  m.U = u0[2] + k1 * P1 + k2 * P2 + b * p;
  m.u = plus(scaled(m.U, n), plus(scaled(u1, e1), scaled(u2, e2)));
  m.W = ((u0[0] + u1) * P1 + (u0[1] + u2) * P2 + (u0[2] + m.U) * p) / 2 + mu * D;
  return m;
}

/// q = −(M + λ)⁻¹ k with |q| = μ. |q| falls with λ, so one λ on either side encloses it.
EnclosedVec diverging(const ImpactProblem<Enclosed>& problem, const EnclosedVec& sticking) {
  if (problem.facts.rest_turns) return scaled(root(Enclosed(problem.cone / inner(sticking, sticking))), sticking);
  const EnclosedContact c(problem);
  const auto q_of = [&](const Enclosed& lambda) {
    const Enclosed a = c.m11 + lambda;
    const Enclosed d = c.m22 + lambda;
    const Enclosed det = a * d - square(c.m12);
    return std::pair(Enclosed((c.m12 * c.k2 - d * c.k1) / det), Enclosed((c.m12 * c.k1 - a * c.k2) / det));
  };
  const auto too_long = [&](const Float& lambda) {
    const auto [q1, q2] = q_of(Enclosed(lambda));
    return square(q1) + square(q2) - problem.cone;
  };
  Float lo = 0;
  Float hi = c.m11.hi() + c.m22.hi();
  while (too_long(hi).middle() > 0) hi *= 2;
  for (int i = 0; i < 260; ++i) {
    const Float middle = (lo + hi) / 2;
    (too_long(middle).middle() > 0 ? lo : hi) = middle;
  }
  const Float off = ldexp(hi, -200);
  const Enclosed lambda(std::max(Float(0), Float(lo - off)), hi + off);
  if (!(too_long(lambda.lo()) > 0) || !(too_long(lambda.hi()) < 0)) throw Undecided("the diverging direction");
  const auto [q1, q2] = q_of(lambda);
  return plus(scaled(q1, c.e1), scaled(q2, c.e2));
}

Sweep::Sweep(const ImpactProblem<Enclosed>& problem) : problem_(problem), contact_(problem) {
  const Enclosed s = root(square(contact_.u0[0]) + square(contact_.u0[1]));
  now_ = {contact_.u0[0] / s, contact_.u0[1] / s, s, Enclosed(0), Enclosed(0)};
}

/// Skips the rest of slip if its direction is near the final one and neither compression nor restitution ends before it
/// stops.
std::unique_ptr<Phase<Enclosed>> Sweep::to_the_stop(const ImpactProgress<Enclosed>& progress) {
  const std::optional<Heading> there = settling(contact_, now_);
  if (!there) return nullptr;
  Field f = field(contact_, there->x, there->y);
  f.H[0] = f.qH[0] = 0;
  if (!f.G[0].is_negative()) return nullptr;
  const Enclosed cosine = there->x * now_.x + there->y * now_.y;
  const Enclosed t = (there->x * now_.y - there->y * now_.x) / (1 + cosine);
  const std::optional<Enclosed> rho = radius_at_stop(f);
  if (!rho || most(t) * 3 > rho->lo()) return nullptr;
  const bool work = problem_.law == Law::stronge;
  const Enclosed p = now_.p + now_.s * remaining(f, 1, *rho).at(t);
  const Enclosed D = work ? now_.D + square(now_.s) * remaining(f, 2, *rho).at(t) : Enclosed(0);
  const ImpactState<Enclosed> from = contact_.impact_state(now_.s * now_.x, now_.s * now_.y, now_.p, now_.D);
  const ImpactState<Enclosed> end = contact_.impact_state(Enclosed(0), Enclosed(0), p, D);
  if (contact_.painleve && !Rise(contact_, *there).keeps_sign(t)) return nullptr;
  if (!progress.quiet(from, end)) return nullptr;
  stopped_ = p;
  return std::make_unique<SkippedPhase<Enclosed>>(from, end);
}

std::unique_ptr<Phase<Enclosed>> Sweep::next(const ImpactProgress<Enclosed>& progress) {
  if (stopped_) return rest(problem_, progress.now());
  if (auto last = to_the_stop(progress)) return last;
  if (++steps_ > most_steps) throw Undecided("slip that turns for too long");
  const Field f = field(contact_, now_.x, now_.y);
  const std::optional<Enclosed> rho = f.H[0].holds_zero() ? std::nullopt : radius_of(f);
  if (!rho) throw Undecided("whether slip turns");
  return arc(progress, f, *rho);
}

/// As far as the series reaches. If U has an extremum in between: first up to it, then across it in one step.
std::unique_ptr<Phase<Enclosed>> Sweep::arc(const ImpactProgress<Enclosed>& progress, const Field& f,
                                            const Enclosed& rho) {
  const Float reach = (rho / 4).lo();
  const Float just = ldexp(reach, -close);
  const bool work = problem_.law == Law::stronge;
  Float length = reach;
  bool turning = false;
  if (contact_.painleve) {
    const auto zero = Rise(contact_, now_).first_zero(f.H[0].is_positive() ? 1 : -1);
    turning = zero && *zero <= 2 * just;
    if (turning) length = 4 * just;
    if (zero && !turning && *zero < reach) length = *zero - just;
  }
  auto arc = std::make_unique<Arc>(contact_, now_, f, rho, length, work);
  if (arc->keeps_rising_or_falling() == turning) throw Undecided("where the normal velocity turns");
  now_ = arc->heading_at_end();
  if (!turning) return arc;
  if (!progress.quiet(arc->begin(), arc->whole())) throw Undecided("a phase that ends where the normal velocity turns");
  return std::make_unique<SkippedPhase<Enclosed>>(arc->begin(), *arc->end(), arc->rises());
}

}  // namespace touchstone::reference
