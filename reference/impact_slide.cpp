#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "reference/impact_lines_impl.h"
#include "reference/impact_slide_impl.h"

namespace touchstone::reference {
namespace {

constexpr std::size_t order = 56;
constexpr int bits_kept = 165;  ///< what a series may leave out, against the first term

/// Any unit vector at right angles to n.
Three<Float> across(const Three<Float>& n) {
  std::size_t least = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (abs(n[i]) < abs(n[least])) least = i;
  }
  Three<Float> axis{};
  axis[least] = 1;
  const Three<Float> t = cross(n, axis);
  return scaled(Float(1 / sqrt(inner(t, t))), t);
}

/// Power series in τ up to `order`.
using Series = std::array<Float, order + 1>;

struct SlipSeries {
  Series x, y, s, p, D;
};

Float product(const Series& a, const Series& b, std::size_t n) {
  Float sum = 0;
  for (std::size_t i = 0; i <= n; ++i) sum += a[i] * b[n - i];
  return sum;
}

Float square(const Series& a, std::size_t n) {
  Float half = 0;
  for (std::size_t i = 0; 2 * i < n; ++i) half += a[i] * a[n - i];
  return n % 2 == 0 ? Float(2 * half + a[n / 2] * a[n / 2]) : Float(2 * half);
}

SlipSeries series(const Tangent& t, const Slip& start) {
  SlipSeries c;
  Series h, g;
  c.x[0] = start.x;
  c.y[0] = start.y;
  c.s[0] = start.s;
  c.p[0] = start.p;
  c.D[0] = start.D;
  const Float turn = t.mu * (t.l1 - t.l2);
  for (std::size_t n = 0; n < order; ++n) {
    h[n] = t.k2 * c.x[n] - t.k1 * c.y[n] + turn * product(c.x, c.y, n);
    g[n] = t.k1 * c.x[n] + t.k2 * c.y[n] - turn * square(c.x, n);
    if (n == 0) g[n] -= t.mu * t.l2;
    const auto next = static_cast<unsigned>(n + 1);
    c.x[n + 1] = -product(h, c.y, n) / next;
    c.y[n + 1] = product(h, c.x, n) / next;
    c.s[n + 1] = product(g, c.s, n) / next;
    c.p[n + 1] = c.s[n] / next;
    c.D[n + 1] = square(c.s, n) / next;
  }
  return c;
}

/// The τ at which |c_n| τⁿ has fallen to 2^-bits_kept of `scale` (Jorba & Zou 2005, without their safety factor: two
/// terms are asked and bits_kept lies well above what is claimed).
Float reach(const Float& c_n, std::size_t n, const Float& scale) {
  const Float ratio = abs(c_n) / scale;
  if (ratio == 0) return Float(0);
  return pow(ldexp(Float(1), -bits_kept) / ratio, Float(1) / static_cast<unsigned>(n));
}

Float step_size(const SlipSeries& c) {
  Float tau = 0;
  const auto limit = [&](const Float& found) {
    if (found > 0 && (tau == 0 || found < tau)) tau = found;
  };
  for (const std::size_t n : {order - 1, order}) {
    limit(reach(c.x[n], n, Float(1)));
    limit(reach(c.y[n], n, Float(1)));
    limit(reach(c.s[n], n, c.s[0]));
    limit(reach(c.D[n] * static_cast<unsigned>(n), n - 1, Float(c.s[0] * c.s[0])));  // D' = s²: may fall twice as fast
  }
  return tau;
}

Float value(const Series& c, const Float& tau) {
  Float sum = c[order];
  for (std::size_t n = order; n-- > 0;) sum = sum * tau + c[n];
  return sum;
}

Slip at(const SlipSeries& c, const Float& tau) {
  return {value(c.x, tau), value(c.y, tau), value(c.s, tau), value(c.p, tau), value(c.D, tau)};
}

/// The zero of a function that is ≤ 0 at lo and ≥ 0 at hi, rising between: Newton's steps, bisection where they leave
/// the bracket. f gives value and derivative.
template <class Function>
Float zero_between(Float lo, Float hi, const Function& f) {
  const Float close = ldexp(hi - lo, -240);
  Float x = (lo + hi) / 2;
  for (int i = 0; i < 600 && hi - lo > close; ++i) {
    const auto [value, derivative] = f(x);
    (value < 0 ? lo : hi) = x;
    if (value == 0) return x;
    Float next = derivative > 0 ? Float(x - value / derivative) : lo;
    if (!(lo < next && next < hi)) next = (lo + hi) / 2;
    if (abs(next - x) <= close) return next;
    x = next;
  }
  return x;
}

}  // namespace

Tangent::Tangent(const Blow<Float>& blow) : n(blow.N), mu(sqrt(blow.cone)) {
  const Three<Float> a1 = across(n);
  const Three<Float> a2 = cross(n, a1);
  const Float m11 = inner(a1, times(blow.K, a1));
  const Float m12 = inner(a1, times(blow.K, a2));
  const Float m22 = inner(a2, times(blow.K, a2));
  // Jacobi's rotation (Golub & Van Loan 2013, 8.5.2).
  Float t = 0;
  if (m12 != 0) {
    const Float z = (m22 - m11) / (2 * m12);
    t = (z < 0 ? -1 : 1) / (abs(z) + sqrt(1 + z * z));
  }
  const Float c = 1 / sqrt(1 + t * t);
  e1 = minus(scaled(c, a1), scaled(Float(t * c), a2));
  e2 = plus(scaled(Float(t * c), a1), scaled(c, a2));
  l1 = inner(e1, times(blow.K, e1));
  l2 = inner(e2, times(blow.K, e2));
  const Three<Float> Kn = times(blow.K, n);
  k1 = inner(e1, Kn);
  k2 = inner(e2, Kn);
  b = inner(n, Kn);
}

/// q = −(M + λ)⁻¹ k with λ > 0 such that |q| = μ. 1/|q| is concave and rising in λ, so Newton's method on 1/|q| = 1/μ
/// from λ = 0 rises to the root (More & Sorensen 1983).
Three<Float> diverging(const Blow<Float>& blow, const Three<Float>& sticking) {
  if (blow.facts.rest_turns) return scaled(Float(sqrt(blow.cone / inner(sticking, sticking))), sticking);
  const Tangent t(blow);
  Float lambda = 0;
  for (int i = 0; i < 400; ++i) {
    const Float q1 = t.k1 / (t.l1 + lambda);
    const Float q2 = t.k2 / (t.l2 + lambda);
    const Float length2 = q1 * q1 + q2 * q2;
    const Float step = (sqrt(length2) / t.mu - 1) * length2 / (q1 * q1 / (t.l1 + lambda) + q2 * q2 / (t.l2 + lambda));
    lambda += step;
    if (abs(step) <= ldexp(lambda, -250)) break;
  }
  const Three<Float> q =
      plus(scaled(Float(-t.k1 / (t.l1 + lambda)), t.e1), scaled(Float(-t.k2 / (t.l2 + lambda)), t.e2));
  return scaled(Float(t.mu / sqrt(inner(q, q))), q);
}

/// A part of a series' range on which U is monotone.
class Piece : public Stretch<Float> {
 public:
  Piece(const Slide& slide, std::shared_ptr<const SlipSeries> c, const Float& from, const Float& to, bool peak)
      : slide_(slide), series_(std::move(c)), begin_(moment(from)), end_(moment(to)), peak_(peak) {}

  const Moment<Float>& begin() const override { return begin_; }
  const Moment<Float>* end() const override { return &end_; }

  std::optional<Moment<Float>> when_p(const Float& c, const Moment<Float>& from) const override {
    if (from.p >= c) return from;
    if (end_.p < c) return {};
    return moment(zero_between(from.at, end_.at, [&](const Float& tau) {
      return std::pair(Float(value(series_->p, tau) - c), value(series_->s, tau));
    }));
  }

  std::optional<Moment<Float>> when_U(const Float& c, const Moment<Float>& from) const override {
    if (from.U >= c) return from;
    if (end_.U < c) return {};
    return moment(zero_between(from.at, end_.at, [&](const Float& tau) {
      const Slip slip = at(*series_, tau);
      return std::pair(Float(slide_.moment(slip).U - c), Float(slip.s * slide_.tangent_.rise(slip.x, slip.y)));
    }));
  }

  /// W' = U s: W rises where U > 0, and U changes sign once at most.
  std::optional<Moment<Float>> when_W(const Float& c, const Moment<Float>& from) const override {
    if (from.W >= c) return from;
    Moment<Float> lo = from;
    Moment<Float> hi = end_;
    if (from.U < 0 && end_.U > 0) lo = *when_U(Float(0), from);
    if (from.U > 0 && end_.U < 0) hi = top_of_W(from);
    if (hi.W < c || hi.U < 0 || lo.W >= c) return {};
    return moment(zero_between(lo.at, hi.at, [&](const Float& tau) {
      const Moment<Float> m = moment(tau);
      return std::pair(Float(m.W - c), Float(m.U * value(series_->s, tau)));
    }));
  }

  Float slope(const Moment<Float>& here) const override {
    const Slip slip = at(*series_, here.at);
    return slide_.tangent_.rise(slip.x, slip.y);
  }

  /// Along a parabola: U'² / (2 |U''|), U'' = μ (k1 y − k2 x) h / s.
  std::optional<Float> rise_left(const Moment<Float>& here) const override {
    const Tangent& t = slide_.tangent_;
    const Slip slip = at(*series_, here.at);
    const Float rise = t.rise(slip.x, slip.y);
    const Float bend = t.mu * (t.k1 * slip.y - t.k2 * slip.x) * t.h(slip.x, slip.y) / slip.s;
    if (rise < 0 || bend >= 0) return {};
    return Float(rise * rise / (-2 * bend));
  }

  bool ends_at_peak() const override { return peak_; }

 private:
  Moment<Float> moment(const Float& tau) const {
    Moment<Float> m = slide_.moment(at(*series_, tau));
    m.at = tau;
    return m;
  }

  Moment<Float> top_of_W(const Moment<Float>& from) const {
    return moment(zero_between(from.at, end_.at, [&](const Float& tau) {
      const Slip slip = at(*series_, tau);
      return std::pair(Float(-slide_.moment(slip).U), Float(-slip.s * slide_.tangent_.rise(slip.x, slip.y)));
    }));
  }

  const Slide& slide_;
  std::shared_ptr<const SlipSeries> series_;
  Moment<Float> begin_, end_;
  bool peak_;
};

/// A slip s changes u by s, and so P by at most s √(tr K⁻¹) in the energy norm; the law is continuous at s = 0.
Slide::Slide(const Blow<Float>& blow) : blow_(blow), tangent_(blow) {
  const Square<Float>& inverse = blow.K_inverse;
  const Float energy = inner(blow.u0, times(inverse, blow.u0));
  negligible_ = ldexp(sqrt(energy / (inverse[0][0] + inverse[1][1] + inverse[2][2])), -200);
  const Float x = inner(tangent_.e1, blow.u0);
  const Float y = inner(tangent_.e2, blow.u0);
  const Float s = sqrt(x * x + y * y);
  first_ = now_ = {Float(x / s), Float(y / s), s, Float(0), Float(0)};
}

/// u_t = s (x, y) gives P_t, P gives u, and the energy's change gives W.
Moment<Float> Slide::moment(const Slip& slip) const {
  const Tangent& t = tangent_;
  Moment<Float> m;
  m.p = slip.p;
  const Float P1 = (slip.s * slip.x - first_.s * first_.x - t.k1 * slip.p) / t.l1;
  const Float P2 = (slip.s * slip.y - first_.s * first_.y - t.k2 * slip.p) / t.l2;
  m.P = plus(scaled(slip.p, t.n), plus(scaled(P1, t.e1), scaled(P2, t.e2)));
  m.u = plus(blow_.u0, times(blow_.K, m.P));
  m.U = inner(m.u, t.n);
  m.W = inner(plus(blow_.u0, m.u), m.P) / 2 + t.mu * slip.D;
  return m;
}

namespace {

/// A direction to which slip turns and in which it decreases: h = 0, h' < 0, g < 0 there; reached at angle −delta from
/// it.
struct Converging {
  Float x, y;
  Float g;
  Float delta;  ///< the angle of slip now, measured from (x, y)
};

Float slope_of_h(const Tangent& t, const Float& x, const Float& y) {
  return -(t.k1 * x + t.k2 * y) + t.mu * (t.l1 - t.l2) * (x * x - y * y);
}

/// By Newton's method, if Kantorovich's condition h |h''| ≤ h'²/8 says that there is such a direction near by.
std::optional<Converging> converging(const Tangent& t, const Slip& slip) {
  Float x = slip.x;
  Float y = slip.y;
  const Float bend = sqrt(t.k1 * t.k1 + t.k2 * t.k2) + 2 * t.mu * abs(t.l1 - t.l2);
  const Float slope = slope_of_h(t, x, y);
  if (slope >= 0 || abs(t.h(x, y)) * bend * 8 > slope * slope) return {};
  for (int i = 0; i < 12; ++i) {
    const Float turn = -t.h(x, y) / slope_of_h(t, x, y);
    const Float turned_x = x - turn * y;
    const Float turned_y = y + turn * x;
    const Float length = sqrt(turned_x * turned_x + turned_y * turned_y);
    x = turned_x / length;
    y = turned_y / length;
    if (abs(turn) < ldexp(Float(1), -140)) break;  // the next turn would be below the last bit
  }
  return Converging{x, y, t.g(x, y), asin(x * slip.y - y * slip.x)};
}

/// How h and g vary with the angle d from a direction, as power series in d.
struct Around {
  std::vector<Float> h, g;
};

Around around(const Tangent& t, const Converging& to, std::size_t terms) {
  const Float kc = t.k1 * to.x + t.k2 * to.y;
  const Float ks = t.k2 * to.x - t.k1 * to.y;
  const Float m = t.mu * (t.l1 - t.l2) / 2;
  const Float s2 = 2 * to.x * to.y;
  const Float c2 = to.x * to.x - to.y * to.y;
  Around result;
  Float one = 1;  // 1/n!
  Float two = 1;  // 2ⁿ/n!
  for (std::size_t n = 0; n < terms; ++n) {
    const bool odd = n % 2 != 0;
    const int sign = n % 4 < 2 ? 1 : -1;  // of cos at 0, 2, 4, … and of sin at 1, 3, 5, …
    result.h.push_back(sign * (odd ? Float(-kc * one + m * c2 * two) : Float(ks * one + m * s2 * two)));
    result.g.push_back(sign * (odd ? Float(ks * one + m * s2 * two) : Float(kc * one - m * c2 * two)));
    one /= static_cast<unsigned>(n + 1);
    two *= 2;
    two /= static_cast<unsigned>(n + 1);
  }
  result.g[0] -= t.mu * (t.l1 + t.l2) / 2;
  return result;
}

/// F(delta) for the solution of h F' + c g F = −1 that is analytic at 0: sᶜ F is what remains of ∫ sᶜ dτ until slip
/// stops. (n h1 + c g0) F_n = −[n = 0] − Σ_{j≥2} h_j (n − j + 1) F_{n−j+1} − c Σ_{j≥1} g_j F_{n−j}; h1, g0 < 0: no
/// resonance. None if the series has not converged.
std::optional<Float> remaining(const Around& a, int c, const Float& delta) {
  std::vector<Float> F;
  Float sum = 0;
  Float power = 1;
  int small = 0;
  for (std::size_t n = 0; n < a.h.size(); ++n) {
    Float rest = n == 0 ? -1 : 0;
    for (std::size_t j = 2; j <= n; ++j) rest -= a.h[j] * static_cast<unsigned>(n - j + 1) * F[n - j + 1];
    for (std::size_t j = 1; j <= n; ++j) rest -= c * a.g[j] * F[n - j];
    F.push_back(rest / (static_cast<unsigned>(n) * a.h[1] + c * a.g[0]));
    const Float term = F[n] * power;
    sum += term;
    power *= delta;
    if (n == 16 && abs(term) > ldexp(abs(sum), -45)) return {};  // too slow to come to an end
    small = abs(term) <= ldexp(abs(sum), -bits_kept - 10) ? small + 1 : 0;
    if (small == 3) return sum;
  }
  return {};
}

/// Nothing happens on it: the law has looked.
class Jump : public Stretch<Float> {
 public:
  Jump(Moment<Float> begin, Moment<Float> end) : begin_(std::move(begin)), end_(std::move(end)) {}
  const Moment<Float>& begin() const override { return begin_; }
  const Moment<Float>* end() const override { return &end_; }
  std::optional<Moment<Float>> when_p(const Float&, const Moment<Float>&) const override { return {}; }
  std::optional<Moment<Float>> when_U(const Float&, const Moment<Float>&) const override { return {}; }
  std::optional<Moment<Float>> when_W(const Float&, const Moment<Float>&) const override { return {}; }
  Float slope(const Moment<Float>&) const override { return Float(0); }
  std::optional<Float> rise_left(const Moment<Float>&) const override { return {}; }
  bool ends_at_peak() const override { return false; }

 private:
  Moment<Float> begin_, end_;
};

/// No zero of dU/dp between two directions less than a half turn apart: it is monotone where k × σ keeps its sign.
bool monotone(const Tangent& t, const Slip& a, const Slip& b) {
  if (t.mu * t.mu * (t.k1 * t.k1 + t.k2 * t.k2) <= t.b * t.b) return true;
  const auto side = [&](const Slip& s) { return Float(t.k1 * s.y - t.k2 * s.x); };
  return side(a) * side(b) >= 0 && t.rise(a.x, a.y) * t.rise(b.x, b.y) >= 0;
}

}  // namespace

/// Finds the direction to which slip settles, and where slip will stop if it will.
void Slide::foresee() {
  constexpr std::size_t terms = 64;
  const auto to = converging(tangent_, now_);
  if (!to) return;
  settled_ = abs(to->delta) <= ldexp(Float(1), -bits_kept);
  if (stop_ || to->g >= 0) return;
  const Around a = around(tangent_, *to, terms);
  const auto rest_of_p = remaining(a, 1, to->delta);
  const auto rest_of_D = remaining(a, 2, to->delta);
  if (!rest_of_p || !rest_of_D) return;
  stop_ = {to->x, to->y, Float(0), Float(now_.p + now_.s * *rest_of_p), Float(now_.D + now_.s * now_.s * *rest_of_D)};
}

/// Slip that turns no more: to its stop, or for ever.
std::unique_ptr<Stretch<Float>> Slide::straight() {
  const Tangent& t = tangent_;
  const Three<Float> slip = plus(scaled(now_.x, t.e1), scaled(now_.y, t.e2));
  const Three<Float> zeta = minus(t.n, scaled(t.mu, slip));
  if (!stop_) return std::make_unique<Ray<Float>>(blow_, moment(now_), zeta);
  stopped_ = stop_->p;
  return std::make_unique<Ray<Float>>(blow_, moment(now_), zeta, Float(stop_->p - now_.p));
}

/// The last stretch of slip at once, if no phase of the impact ends on it.
std::unique_ptr<Stretch<Float>> Slide::jump(const Walk<Float>& walk) {
  const Moment<Float> from = moment(now_);
  const Moment<Float> end = moment(*stop_);
  if (!monotone(tangent_, now_, *stop_) || !walk.quiet(from, end)) return nullptr;
  stopped_ = stop_->p;
  return std::make_unique<Jump>(from, end);
}

/// One series, cut where U turns.
void Slide::step() {
  const auto c = std::make_shared<const SlipSeries>(series(tangent_, now_));
  const Float whole = step_size(*c);
  std::vector<Float> cuts = {Float(0), whole};
  const auto cut_where = [&](const auto& f) {
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      const Float a = f(at(*c, cuts[i - 1]));
      const Float b = f(at(*c, cuts[i]));
      if (a * b >= 0) continue;
      const int sign = a < 0 ? 1 : -1;
      const Float cut = zero_between(
          cuts[i - 1], cuts[i], [&](const Float& tau) { return std::pair(Float(sign * f(at(*c, tau))), Float(0)); });
      cuts.insert(cuts.begin() + static_cast<std::ptrdiff_t>(i++), cut);
    }
  };
  const Tangent& t = tangent_;
  if (!(t.mu * t.mu * (t.k1 * t.k1 + t.k2 * t.k2) <= t.b * t.b)) {
    cut_where([&](const Slip& s) { return Float(t.k1 * s.y - t.k2 * s.x); });
    cut_where([&](const Slip& s) { return t.rise(s.x, s.y); });
  }
  const auto rises = [&](std::size_t i) {
    const Slip middle = at(*c, (cuts[i] + cuts[i + 1]) / 2);
    return t.rise(middle.x, middle.y) > 0;
  };
  for (std::size_t i = cuts.size() - 1; i-- > 0;) {
    const bool peak = i + 2 < cuts.size() && rises(i) && !rises(i + 1);
    pieces_.push_back(std::make_unique<Piece>(*this, c, cuts[i], cuts[i + 1], peak));
  }
  now_ = at(*c, whole);
  const Float length = sqrt(now_.x * now_.x + now_.y * now_.y);  // holds rounding down
  now_.x /= length;
  now_.y /= length;
}

std::unique_ptr<Stretch<Float>> Slide::next(const Walk<Float>& walk) {
  if (pieces_.empty()) {
    if (!stopped_ && now_.s <= negligible_) stopped_ = now_.p;
    if (stopped_) return rest(blow_, walk.now());
    foresee();
    if (stop_) {
      if (auto last = jump(walk)) return last;
    }
    if (settled_) return straight();
    step();
  }
  auto piece = std::move(pieces_.back());
  pieces_.pop_back();
  return piece;
}

}  // namespace touchstone::reference
