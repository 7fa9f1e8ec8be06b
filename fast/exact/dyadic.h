// Integer multiples of powers of two, exactly: every finite double is one, and so are sums and products of them.
//
// Expansions of doubles would be faster but are limited by the range of exponents: a determinant of vertices in poses
// multiplies fifteen doubles, so lengths of 1e100 overflow and lengths of 1e-100 vanish. Dyadic numbers have no such
// limit.
#pragma once

#include "fast/exact/limbs.h"

namespace touchstone::fast::exact {

class Dyadic {
 public:
  Dyadic() = default;
  /// Requires a finite x.
  Dyadic(double x);  // NOLINT: a double is one

  /// -1, 0, 1.
  int sign() const { return sign_; }

  Dyadic operator-() const;
  friend Dyadic operator+(const Dyadic& x, const Dyadic& y) { return sum(x, y, y.sign_); }
  friend Dyadic operator-(const Dyadic& x, const Dyadic& y) { return sum(x, y, -y.sign_); }
  friend Dyadic operator*(const Dyadic& x, const Dyadic& y);

  /// m · 2^exponent with 1/2 ≤ |m| < 1, m truncated towards 0: |m| 2^exponent ≤ |x| < |m| 2^exponent (1 + 2^-52). 0
  /// gives 0.
  struct Scientific {
    double m = 0;
    long exponent = 0;
  };
  Scientific scientific() const;

  /// scientific() as a double; ±infinity or 0 beyond the range.
  double approximate() const;

 private:
  static Dyadic sum(const Dyadic& x, const Dyadic& y, int sign_of_y);
  static Dyadic sum_of_others(const Dyadic& x, const Dyadic& y, int sign_of_y);
  void trim();

  int sign_ = 0;
  long lowest_ = 0;  ///< |x| = Σ limbs_[i] 2^(64 (lowest_ + i))
  Limbs limbs_;      ///< first and last are not 0; empty for 0
};

inline Dyadic magnitude(const Dyadic& x) { return x.sign() < 0 ? -x : x; }

/// The same as a double; ±infinity or 0 beyond the range.
double approximate(const Dyadic::Scientific& x);

/// x/y, y ≠ 0, as a double times 2^exponent: relative error < 6u.
Dyadic::Scientific quotient(const Dyadic& x, const Dyadic& y);
/// x/y in doubles, y ≠ 0: relative error < 6u; ±infinity or 0 beyond the range.
double ratio(const Dyadic& x, const Dyadic& y);
/// √(x/y) in doubles, x ≥ 0, y > 0: relative error < 4u; infinity or 0 beyond the range.
double root_of_ratio(const Dyadic& x, const Dyadic& y);

}  // namespace touchstone::fast::exact
