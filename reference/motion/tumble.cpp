#include "reference/motion/tumble.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "reference/exact/elliptic.h"
#include "reference/motion/principal_axes.h"

namespace touchstone::reference {
namespace {

using Wide = WideEnclosure;

template <class T>
Coordinates<T> entrywise(const Coordinates<T>& a, const Coordinates<T>& b) {
  return {T(a.x * b.x), T(a.y * b.y), T(a.z * b.z)};
}

template <class T>
Coordinates<T> combined(const std::array<Coordinates<T>, 3>& axes, const Coordinates<T>& v) {
  return v.x * axes[0] + v.y * axes[1] + v.z * axes[2];
}

Coordinates<Wide> along(const std::array<Coordinates<Wide>, 3>& axes, const Coordinates<Wide>& v) {
  return {dot(axes[0], v), dot(axes[1], v), dot(axes[2], v)};
}

template <class T>
Rotor<T> conjugate(const Rotor<T>& q) {
  return {q[0], T(-q[1]), T(-q[2]), T(-q[3])};
}

template <class T>
T anything() {
  using P = decltype(lower(T()));
  const P infinite = std::numeric_limits<P>::infinity();
  return between(P(-infinite), infinite);
}

Wide square(const Wide& x) {
  const Wide found = x * x;
  return between(std::max(lower(found), Float(0)), upper(found));
}

/// e^-x for x ≥ 0.
Wide decayed(const Wide& x) { return exp(Wide(-x)); }
Enclosure decayed(const Enclosure& x) {
  mpfr_t power;
  mpfr_init2(power, 53);
  const auto at = [&](double end, mpfr_rnd_t round) {
    mpfr_set_d(power, -end, MPFR_RNDN);
    mpfr_exp(power, power, round);
    return mpfr_get_d(power, round);
  };
  const Enclosure found(at(x.sup(), MPFR_RNDD), at(x.inf(), MPFR_RNDU));
  mpfr_clear(power);
  return found;
}

/// The interval from one to the other.
Wide around(const Wide& x, const Wide& y) { return between(std::min(lower(x), lower(y)), greater(upper(x), upper(y))); }

template <class E>
E plus_or_minus(double off) {
  using P = decltype(lower(E()));
  return between(P(-off), P(off));
}

Coordinates<Enclosure> in_doubles(const Coordinates<Wide>& v) {
  return {converted<Enclosure>(v.x), converted<Enclosure>(v.y), converted<Enclosure>(v.z)};
}

Rotor<Enclosure> in_doubles(const Rotor<Wide>& q) {
  return {converted<Enclosure>(q[0]), converted<Enclosure>(q[1]), converted<Enclosure>(q[2]),
          converted<Enclosure>(q[3])};
}

/// The series are cut at the first weight below 2^-300. From there on, among the first 512, each weight is less than
/// half the one before (2 q^(m²/4) < 2^-300 at m has ratios below e^(-416/m)). So all the weights left out, even times
/// m, sum to less than `left_out`.
constexpr double negligible = 0x1p-300, left_out = 0x1p-288;
constexpr int most_terms = 512;

/// Of a motion near a rotation about an axis: the error of its angular velocity, as a share of it, and of its attitude,
/// rad.
constexpr double negligible_spread = 0x1p-64;

Wide pi() { return acos(Wide(-1)); }

}  // namespace

/// In P, at τ = 0.
struct Tumble::Invariants {
  Coordinates<Wide> I, w;
  Wide L, twice_T;
  Wide a, b, d;       ///< |c|
  Wide A, D, lambda;  ///< as in reference/motion/tumble.h
  Coordinates<Wide> W;
  Wide sigma;
};

Tumble::Tumble(const Square<mpq_class>& I_B, const std::array<mpq_class, 4>& q, const Three<mpq_class>& w_B) {
  turning_ = anything<Wide>();
  for (std::size_t i = 0; i < 4; ++i) wide_.q[i] = enclosed<Wide>(q[i]);
  const PrincipalAxes found = principal_axes(I_B);
  set_tumble(I_B, w_B, found);
  if (!wide_.known) set_near_axis(enclosed<Wide>(w_B), found);
}

void Tumble::set_tumble(const Square<mpq_class>& I_B, const Three<mpq_class>& w_B, const PrincipalAxes& found) {
  const Three<mpq_class> L_B = times(I_B, w_B);
  const mpq_class L_squared = inner(L_B, L_B), twice_T = inner(L_B, w_B), ratio = L_squared / twice_T;
  Square<mpq_class> left = I_B;
  for (std::size_t i = 0; i < 3; ++i) left[i][i] -= ratio;
  wide_.returns = determinant(left) != 0;  // else L²/2T is a moment: the middle one, since ω is not along an axis

  const Wide beyond = enclosed<Wide>(ratio) - found.moments[1];
  const bool about_greatest = middle(beyond) > 0;  // if k = 1, both choices are right
  if (wide_.returns && !(lower(beyond) > 0 || upper(beyond) < 0)) return;
  const std::size_t third = about_greatest ? 2 : 0;
  const Coordinates<Wide> w = enclosed<Wide>(w_B);
  const auto forward = [&](const Coordinates<Wide>& e) { return middle(dot(e, w)) < 0 ? -e : e; };
  std::array<Coordinates<Wide>, 3>& axes = wide_.axes;
  axes[2] = forward(found.axes[third]);
  axes[0] = forward(found.axes[2 - third]);
  axes[1] = cross(axes[2], axes[0]);

  Invariants of;
  of.I = {found.moments[2 - third], found.moments[1], found.moments[third]};
  of.w = along(axes, w);
  of.L = root(enclosed<Wide>(L_squared));
  of.twice_T = enclosed<Wide>(twice_T);
  const Coordinates<Wide> c = {Wide((of.I.y - of.I.z) / of.I.x), Wide((of.I.z - of.I.x) / of.I.y),
                               Wide((of.I.x - of.I.y) / of.I.z)};
  const Wide sign(about_greatest ? 1 : -1);
  of.sigma = -sign;
  of.a = -sign * c.x;
  of.b = sign * c.y;
  of.d = -sign * c.z;
  of.A = of.b * square(of.w.x) + of.a * square(of.w.y);
  of.D = of.d * square(of.w.y) + of.b * square(of.w.z);
  of.lambda = root(Wide(of.a * of.D));
  of.W.x = root(Wide(of.A / of.b));
  of.W.z = root(Wide(of.D / of.b));
  of.W.y = c.y * of.W.x * of.W.z / of.lambda;
  if (!(lower(of.a) > 0 && lower(of.b) > 0 && lower(of.d) > 0 && lower(of.A) > 0 && lower(of.D) > 0)) return;

  wide_.W = of.W;
  wide_.share = Wide(Wide(1) / of.L) * of.I;
  if (wide_.returns) {
    set_waves(of);
  } else {
    set_last_wave(of);
  }
  if (!wide_.known) return;
  wide_.back = conjugate(in_P(wide_, Wide(0)).q);
  const Wide alpha =
      length(entrywise(c, Coordinates<Wide>{Wide(of.W.y * of.W.z), Wide(of.W.z * of.W.x), Wide(of.W.x * of.W.y)}));
  // |ω|² is linear in sn² s: it is greatest at sn = 0 or at sn = 1.
  const Wide even = square(of.W.x) + square(of.W.z),
             odd = square(of.W.y) + square(of.W.z) - of.d * of.A / (of.a * of.b);
  turning_ = around(even, odd) + alpha;

  narrow_ = {true,
             wide_.returns,
             converted<Enclosure>(wide_.phase),
             converted<Enclosure>(wide_.rate),
             converted<Enclosure>(wide_.spin),
             in_doubles(wide_.W),
             in_doubles(wide_.share),
             {},
             converted<Enclosure>(wide_.lean),
             {in_doubles(axes[0]), in_doubles(axes[1]), in_doubles(axes[2])},
             in_doubles(wide_.q),
             in_doubles(wide_.back)};
  for (const Weight<Wide>& x : wide_.series) {
    narrow_.series.push_back({converted<Enclosure>(x.plain), converted<Enclosure>(x.alternating),
                              converted<Enclosure>(x.real), converted<Enclosure>(x.imaginary)});
  }
}

/// For a motion near a rotation about the axis e with ω_0 = ω·e: with δ the rest of ω, |ω| ≤ Ω = |L|/(least moment) and
/// κ = max |c_i|, Euler's equations give |ω'| ≤ κ Ω², |δ| ≤ g = |δ_0| exp(κ Ω τ) and |ω·e − ω_0| ≤ κ g² τ. The attitude
/// is within half the integral of the sum of these of a rotation about e at the rate ω_0.
void Tumble::set_near_axis(const Coordinates<Wide>& w, const PrincipalAxes& found) {
  const auto size = [&](const Coordinates<Wide>& e) { return abs(middle(dot(e, w))); };
  const auto& e = *std::ranges::max_element(found.axes, {}, size);
  const auto& I = found.moments;
  const auto coefficient = [&](std::size_t i) {
    const Wide c = (I[(i + 1) % 3] - I[(i + 2) % 3]) / I[i];
    return greater(upper(c), Float(-lower(c)));
  };
  const Coordinates<Wide> of_axes = along(found.axes, w);
  const Wide L = length(entrywise(Coordinates<Wide>{I[0], I[1], I[2]}, of_axes)), rate = dot(e, w);
  const Wide unequal = thin(greater(coefficient(0), greater(coefficient(1), coefficient(2)))), fastest = L / I[0];
  turning_ = thin(upper(Wide((Wide(1) + unequal) * fastest * fastest)));
  wide_near_ = {wide_.q, e, rate, length(Coordinates<Wide>(w - rate * e)), unequal * fastest, unequal};
  narrow_near_ = {in_doubles(wide_.q),
                  in_doubles(e),
                  converted<Enclosure>(rate),
                  converted<Enclosure>(wide_near_.off),
                  converted<Enclosure>(wide_near_.growth),
                  converted<Enclosure>(unequal)};
}

/// For k < 1.
void Tumble::set_waves(const Invariants& of) {
  const Wide one(1), two(2);
  const Wide k_squared = of.d * of.A / (of.a * of.D);
  const Wide rest = of.b * (of.a * square(of.w.z) - of.d * square(of.w.x)) / (of.a * of.D);  // 1 − k²
  if (!(lower(rest) > 0)) return;
  const Wide K = first_kind(Wide(0), rest, one), K_other = first_kind(Wide(0), k_squared, one);
  const Wide sn = of.w.y / of.W.y, cn = of.w.x / of.W.x, dn = of.w.z / of.W.z;
  Wide s = sn * first_kind(square(cn), square(dn), one);
  // cn is about 0, so s is about K or −K
  if (!(lower(cn) > 0)) s = around(s, Wide((lower(sn) > 0 ? two : -two) * K - s));
  const Wide to_v = pi() / (two * K);
  wide_.phase = to_v * s;
  wide_.rate = to_v * of.lambda;
  wide_.lean = of.sigma;

  const Wide across = square(of.I.x * of.W.x / (of.I.z * of.W.z));  // (|L|/(I_3 W_3))² − 1
  const Wide all = across + k_squared;
  const Wide eta =
      root(Wide(across / all)) * first_kind(Wide(k_squared / all), Wide((one + across) * k_squared / all), one);
  const Wide delta = to_v * eta;
  const Wide decay = pi() * K_other / K;  // −ln q
  const Wide none = plus_or_minus<Wide>(left_out);
  Wide theta_2 = none, theta_3 = one + none, theta_4 = theta_3, real = theta_3, slope = none;
  for (int m = 1;; ++m) {
    if (m > most_terms) return;
    const int n = m / 2;
    const Wide sign(n % 2 == 0 ? 1 : -1);
    Weight<Wide> weight = {two * decayed(Wide(decay * Wide(m * m) / Wide(4))), Wide(0), Wide(0), Wide(0)};
    weight.alternating = sign * weight.plain;
    if (m % 2 == 1) {
      theta_2 += weight.plain;
    } else {
      const Wide up = decayed(Wide(Wide(2 * n * n) * decay - Wide(2 * n) * delta));
      const Wide down = decayed(Wide(Wide(2 * n * n) * decay + Wide(2 * n) * delta));
      weight.real = sign * (up + down);
      weight.imaginary = -sign * (up - down);
      theta_3 += weight.plain;
      theta_4 += weight.alternating;
      real += weight.real;
      slope += Wide(2 * n) * weight.imaginary;
      if (upper(weight.plain) < Float(negligible)) break;
    }
    wide_.series.push_back(weight);
  }
  wide_.W = {Wide(of.W.x * theta_4 / theta_2), Wide(of.W.y * theta_3 / theta_2), Wide(of.W.z * theta_4 / theta_3)};
  const Wide first = (of.twice_T + of.L * of.W.z) / (of.L + of.I.z * of.W.z);
  wide_.spin = first / two - of.sigma * wide_.rate * slope / real;
  wide_.known = true;
}

/// For k = 1.
void Tumble::set_last_wave(const Invariants& of) {
  const Wide one(1), two(2);
  const Wide sn = of.w.y / of.W.y, cn = of.w.x / of.W.x;
  wide_.phase = log(Wide((one + sn) / cn));  // tanh s = sn, 1/cosh s = cn
  wide_.rate = of.lambda;
  wide_.spin = of.L / of.I.y / two;
  const Wide cosine = of.I.z * of.W.z / of.L;
  wide_.lean = of.sigma * root(Wide((one - cosine) / (one + cosine)));
  wide_.known = true;
}

template <class E>
Tumble::Wave<E> Tumble::wave(const Constants<E>& constants, const E& tau) {
  const auto [cosine, sine] = cosine_and_sine(E(constants.phase + constants.rate * tau));
  const E none = plus_or_minus<E>(left_out);
  E theta_1 = none, theta_2 = none, theta_3 = E(1) + none, theta_4 = theta_3, real = theta_3, imaginary = none;
  E c = cosine, s = sine;  // of m v
  bool odd = true;
  for (const Weight<E>& weight : constants.series) {
    if (odd) {
      theta_1 += weight.alternating * s;
      theta_2 += weight.plain * c;
    } else {
      theta_3 += weight.plain * c;
      theta_4 += weight.alternating * c;
      real += weight.real * c;
      imaginary += weight.imaginary * s;
    }
    const E next = c * cosine - s * sine;
    s = s * cosine + c * sine;
    c = next;
    odd = !odd;
  }
  return {E(theta_2 / theta_4), E(theta_1 / theta_4), E(theta_3 / theta_4), real, E(constants.lean * imaginary)};
}

template <class E>
Tumble::Wave<E> Tumble::last_wave(const Constants<E>& constants, const E& tau) {
  const E s = constants.phase + constants.rate * tau, one(1);
  const bool before = middle(s) < 0;
  const E g = decayed(before ? E(-s) : s);
  const E sign(before ? -1 : 1), sum = one + g * g;
  const E sech = E(2) * g / sum;
  return {sech, E(sign * (one - g * g) / sum), sech, one, E(sign * constants.lean * (one - g) / (one + g))};
}

/// q_NP, and ω in P.
template <class E>
Tumble::At<E> Tumble::in_P(const Constants<E>& constants, const E& tau) {
  const Wave<E> now = constants.returns ? wave(constants, tau) : last_wave(constants, tau);
  const Coordinates<E> w = entrywise(constants.W, Coordinates<E>{now.cn, now.sn, now.dn});
  const Coordinates<E> l = entrywise(constants.share, w);
  const E turned = E(1) + l.z;
  const E long_p = root(E(E(2) * turned));
  const auto [cosine, sine] = cosine_and_sine(E(constants.spin * tau));
  const E size = root(E(now.real * now.real + now.imaginary * now.imaginary)) * long_p;
  const E c = (cosine * now.real - sine * now.imaginary) / size;
  const E s = (sine * now.real + cosine * now.imaginary) / size;
  return {{E(c * turned), E(c * l.y + s * l.x), E(s * l.y - c * l.x), E(s * turned)}, w};
}

template <class E>
Tumble::At<E> Tumble::at(const NearAxis<E>& near, const E& tau) {
  using P = decltype(lower(tau));
  const E time = thin(greater(upper(tau), P(-lower(tau))));
  const E aside = near.off / decayed(E(near.growth * time));
  const E spread = aside + near.unequal * aside * aside * time, angle = spread * time / E(2);
  const E most(negligible_spread), fastest = most * near.rate;
  if (!(upper(spread) <= greater(lower(fastest), P(-upper(fastest))) && upper(angle) <= lower(most))) {
    const E any = anything<E>();
    return {{any, any, any, any}, {any, any, any}};
  }
  const auto around_zero = [](const E& x) { return between(P(-upper(x)), upper(x)); };
  const Coordinates<E>& e = near.axis;
  const auto [cosine, sine] = cosine_and_sine(E(near.rate * tau / E(2)));
  At<E> now = {near.q * Rotor<E>{cosine, E(sine * e.x), E(sine * e.y), E(sine * e.z)}, near.rate * e};
  E length_squared(0);
  for (const E& part : near.q) length_squared += part * part;
  for (E& part : now.q) part += around_zero(E(root(length_squared) * angle));
  for (E* part : {&now.w_B.x, &now.w_B.y, &now.w_B.z}) *part += around_zero(spread);
  return now;
}

template <class E>
Tumble::At<E> Tumble::at(const Constants<E>& constants, const E& tau) {
  const At<E> there = in_P(constants, tau);
  const Rotor<E> turn = constants.back * there.q;
  const Coordinates<E> v = combined(constants.axes, {turn[1], turn[2], turn[3]});
  return {constants.q * Rotor<E>{turn[0], v.x, v.y, v.z}, combined(constants.axes, there.w_B)};
}

Tumble::At<Enclosure> Tumble::at(const Enclosure& tau) const {
  return narrow_.known ? at(narrow_, tau) : at(narrow_near_, tau);
}
Tumble::At<WideEnclosure> Tumble::at(const WideEnclosure& tau) const {
  return wide_.known ? at(wide_, tau) : at(wide_near_, tau);
}

}  // namespace touchstone::reference
