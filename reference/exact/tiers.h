// One algorithm in two interval arithmetics: doubles, and 76 digits for what doubles cannot decide.
//
// E is an enclosure of a real number, P a plain number of the same precision. Guesses are made in P, proofs in E.
#pragma once

#include <CGAL/Interval_nt.h>
#include <gmpxx.h>
#include <mpfr.h>

#include <algorithm>
#include <boost/multiprecision/mpfi.hpp>
#include <utility>

#include "reference/exact/coordinates.h"
#include "reference/exact/exact_pose.h"
#include "reference/exact/float.h"

namespace touchstone::reference {

using WideEnclosure =
    boost::multiprecision::number<boost::multiprecision::mpfi_float_backend<76>, boost::multiprecision::et_off>;

/// Where to try to prove contact after the last time that is proved apart: at first, first·factor, ..., as parts of the
/// time.
struct Probing {
  double first, factor;
  int tries;
};

struct InDoubles {
  using E = Enclosure;
  using P = double;
  using Scope = RoundUpward;  ///< E is an enclosure only inside such a scope; P stays outside

  static constexpr int most_steps = 20000;
  static constexpr double resolution = 0;  ///< steps continue as long as they make progress
  static constexpr Probing probing = {0, 1, 0};
  static constexpr Probing last_probing = {0x1p-53, 1.7, 20};
};

struct InWide {
  using E = WideEnclosure;
  using P = Float;

  static constexpr int most_steps = 1000;  ///< some ms each

  /// Doubles do not resolve shorter steps. But where the two bodies do not touch, shorter steps may lead past the near
  /// miss.
  static constexpr double resolution = 0x1p-60;
  static constexpr Probing probing = {0x1p-62, 16, 3};
  static constexpr Probing last_probing = {0x1p-62, 4, 24};

  struct Scope {
    Scope() {}  // an empty scope, without a warning about an unused variable
  };
};

inline double lower(const Enclosure& x) { return x.inf(); }
inline double upper(const Enclosure& x) { return x.sup(); }
inline double middle(const Enclosure& x) { return x.inf() + (x.sup() - x.inf()) / 2; }

inline Float lower(const WideEnclosure& x) {
  Float f;
  mpfi_get_left(f.backend().data(), x.backend().data());
  return f;
}

inline Float upper(const WideEnclosure& x) {
  Float f;
  mpfi_get_right(f.backend().data(), x.backend().data());
  return f;
}

inline Float middle(const WideEnclosure& x) {
  Float f;
  mpfi_mid(f.backend().data(), x.backend().data());
  return f;
}

/// The lesser and the greater of two ends. NaN if either is NaN, so that NaN proves nothing.
template <class P>
P lesser(const P& a, const P& b) {
  return a != a || a <= b ? a : b;
}
template <class P>
P greater(const P& a, const P& b) {
  return a != a || a >= b ? a : b;
}

inline Enclosure between(double lo, double hi) { return Enclosure(lo, hi); }

inline WideEnclosure between(const Float& lo, const Float& hi) {
  WideEnclosure x;
  mpfi_interv_fr(x.backend().data(), lo.backend().data(), hi.backend().data());
  return x;
}

inline Enclosure thin(double x) { return Enclosure(x); }
inline WideEnclosure thin(const Float& x) { return between(x, x); }

template <class P>
auto thin(const Coordinates<P>& v) {
  return Coordinates<decltype(thin(v.x))>{thin(v.x), thin(v.y), thin(v.z)};
}

template <class E>
auto middle(const Coordinates<E>& v) {
  return Coordinates<decltype(middle(v.x))>{middle(v.x), middle(v.y), middle(v.z)};
}

/// An enclosure of q.
template <class E>
E enclosed(const mpq_class& q);

template <>
inline WideEnclosure enclosed(const mpq_class& q) {
  WideEnclosure x;
  mpfi_set_q(x.backend().data(), q.get_mpq_t());
  return x;
}

template <>
inline Enclosure enclosed(const mpq_class& q) {
  mpfr_t rounded;
  mpfr_init2(rounded, 53);
  const bool exact = mpfr_set_q(rounded, q.get_mpq_t(), MPFR_RNDD) == 0;
  // mpfr has a wider exponent range: rounds again at the ends of the range of doubles
  const double lo = mpfr_get_d(rounded, MPFR_RNDD);
  if (!exact) mpfr_nextabove(rounded);
  const double hi = mpfr_get_d(rounded, MPFR_RNDU);
  mpfr_clear(rounded);
  return Enclosure(lo, hi);
}

template <class E>
Coordinates<E> enclosed(const std::array<mpq_class, 3>& v) {
  return {enclosed<E>(v[0]), enclosed<E>(v[1]), enclosed<E>(v[2])};
}

/// The tightest doubles around a wide enclosure.
inline Interval in_doubles(const WideEnclosure& x) {
  const Float lo = lower(x);
  const Float hi = upper(x);
  return {mpfr_get_d(lo.backend().data(), MPFR_RNDD), mpfr_get_d(hi.backend().data(), MPFR_RNDU)};
}

inline Interval in_doubles(const Enclosure& x) { return {x.inf(), x.sup()}; }

template <class E>
E converted(const WideEnclosure& x);

template <>
inline WideEnclosure converted(const WideEnclosure& x) {
  return x;
}

template <>
inline Enclosure converted(const WideEnclosure& x) {
  const Interval around = in_doubles(x);
  return Enclosure(around.lo, around.hi);
}

/// A number not above x.
template <class P>
P rounded_down(const Float& x);

template <>
inline Float rounded_down(const Float& x) {
  return x;
}

template <>
inline double rounded_down(const Float& x) {
  return mpfr_get_d(x.backend().data(), MPFR_RNDD);
}

/// Widens by some ulps.
inline Enclosure widened(const Enclosure& x) { return x * Enclosure(1 - 0x1p-52, 1 + 0x1p-52); }
inline WideEnclosure widened(const WideEnclosure& x) {
  const Float off = ldexp(Float(1), -250);
  return x * between(Float(1 - off), Float(1 + off));
}

/// The root of a number that cannot be negative.
inline Enclosure root(const Enclosure& x) {
  return CGAL::sqrt(Enclosure(std::max(x.inf(), 0.0), std::max(x.sup(), 0.0)));
}

inline WideEnclosure root(const WideEnclosure& x) {
  const Float none = 0;
  return sqrt(between(std::max(lower(x), none), std::max(upper(x), none)));
}

template <class E>
E length(const Coordinates<E>& v) {
  return root(E(dot(v, v)));
}

inline std::pair<WideEnclosure, WideEnclosure> cosine_and_sine(const WideEnclosure& x) { return {cos(x), sin(x)}; }

/// At the middle both values are correctly rounded, so within 2^-54. The slopes are at most 1.
inline std::pair<Enclosure, Enclosure> cosine_and_sine(const Enclosure& x) {
  const double at = middle(x);
  const Enclosure around = Enclosure(at) - x;
  const double off = std::max(around.sup(), -around.inf()) + 0x1p-54;  // rounded upward, as x is
  mpfr_t angle, sine, cosine;
  mpfr_inits2(53, angle, sine, cosine, static_cast<mpfr_ptr>(nullptr));
  mpfr_set_d(angle, at, MPFR_RNDN);
  mpfr_sin_cos(sine, cosine, angle, MPFR_RNDN);
  const Enclosure spread(-off, off);
  const std::pair<Enclosure, Enclosure> both = {Enclosure(mpfr_get_d(cosine, MPFR_RNDN)) + spread,
                                                Enclosure(mpfr_get_d(sine, MPFR_RNDN)) + spread};
  mpfr_clears(angle, sine, cosine, static_cast<mpfr_ptr>(nullptr));
  return both;
}

}  // namespace touchstone::reference
