// A floating-point number of two doubles: the sum hi + lo, |lo| at most half an ulp of hi. Some 104 bits, with the
// exponent range of a double.
//
// The operations are those of Joldes, Muller & Popescu 2017, who prove their relative errors, with u = 2^-53: sum 3u² +
// 13u³ (Algorithm 6), product 5u² (10), quotient 15u² (17), if nothing overflows or underflows. Requires rounding to
// nearest.
#pragma once

#include <gmpxx.h>

#include <cmath>

namespace touchstone::reference {

struct DoubleDouble {
  double hi = 0;
  double lo = 0;

  constexpr DoubleDouble() = default;
  constexpr DoubleDouble(double x) : hi(x) {}  // NOLINT: every double is one
  constexpr DoubleDouble(double high, double low) : hi(high), lo(low) {}

  explicit operator double() const { return hi; }
  DoubleDouble operator-() const { return {-hi, -lo}; }

  /// a + b exactly, if |a| ≥ |b| (Dekker 1971).
  static DoubleDouble sum_of_sorted(double a, double b) {
    const double s = a + b;
    return {s, b - (s - a)};
  }

  /// a + b exactly (Knuth).
  static DoubleDouble sum(double a, double b) {
    const double s = a + b;
    const double b_part = s - a;
    return {s, (a - (s - b_part)) + (b - b_part)};
  }

  /// a b exactly, by Veltkamp's halves (Dekker 1971).
  static DoubleDouble product(double a, double b) {
    const double p = a * b;
    const DoubleDouble x = halves(a);
    const DoubleDouble y = halves(b);
    return {p, ((x.hi * y.hi - p) + x.hi * y.lo + x.lo * y.hi) + x.lo * y.lo};
  }

  friend DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y) {
    const DoubleDouble s = sum(x.hi, y.hi);
    const DoubleDouble t = sum(x.lo, y.lo);
    const DoubleDouble v = sum_of_sorted(s.hi, s.lo + t.hi);
    return sum_of_sorted(v.hi, t.lo + v.lo);
  }
  friend DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) { return x + -y; }

  friend DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y) {
    const DoubleDouble p = product(x.hi, y.hi);
    return sum_of_sorted(p.hi, p.lo + (x.hi * y.lo + x.lo * y.hi));
  }

  friend DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y) {
    const double t = x.hi / y.hi;
    const DoubleDouble p = product(t, y.hi);
    const DoubleDouble r = sum_of_sorted(p.hi, p.lo + t * y.lo);
    const double rest = (x.hi - r.hi) + (x.lo - r.lo);
    return sum_of_sorted(t, rest / y.hi);
  }

  DoubleDouble& operator+=(const DoubleDouble& y) { return *this = *this + y; }
  DoubleDouble& operator-=(const DoubleDouble& y) { return *this = *this - y; }
  DoubleDouble& operator*=(const DoubleDouble& y) { return *this = *this * y; }
  DoubleDouble& operator/=(const DoubleDouble& y) { return *this = *this / y; }

  friend bool operator==(const DoubleDouble& x, const DoubleDouble& y) = default;
  friend bool operator<(const DoubleDouble& x, const DoubleDouble& y) {
    return x.hi < y.hi || (x.hi == y.hi && x.lo < y.lo);
  }
  friend bool operator>(const DoubleDouble& x, const DoubleDouble& y) { return y < x; }
  friend bool operator<=(const DoubleDouble& x, const DoubleDouble& y) { return !(y < x); }
  friend bool operator>=(const DoubleDouble& x, const DoubleDouble& y) { return !(x < y); }

 private:
  static DoubleDouble halves(double a) {
    const double c = 0x1.0000002p27 * a;
    const double high = c - (c - a);
    return {high, a - high};
  }
};

inline DoubleDouble abs(const DoubleDouble& x) { return x.hi < 0 ? -x : x; }

inline DoubleDouble ldexp(const DoubleDouble& x, int k) { return {std::ldexp(x.hi, k), std::ldexp(x.lo, k)}; }

/// One Newton step from the root of the double: the remainder of x, over twice that root.
inline DoubleDouble sqrt(const DoubleDouble& x) {
  if (x.hi <= 0) return 0.0;
  const double r = std::sqrt(x.hi);
  const DoubleDouble rest = x - DoubleDouble::product(r, r);
  return DoubleDouble::sum_of_sorted(r, rest.hi / (2 * r));
}

inline mpq_class exact_of(const DoubleDouble& x) { return mpq_class(mpq_class(x.hi) + mpq_class(x.lo)); }

}  // namespace touchstone::reference
