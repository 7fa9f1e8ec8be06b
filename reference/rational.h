// An exact rational as a plain value. GMP is hidden in exact/rational.cpp.
#pragma once

#include <compare>
#include <memory>
#include <string>

#include "model/frame.h"

namespace touchstone::reference {

/// A rational number, always in lowest terms with a positive denominator.
/// A moved-from value may only be assigned or destroyed.
class Rational {
 public:
  Rational();              ///< 0
  Rational(double exact);  ///< NOLINT: the exact value of the double; throws std::invalid_argument unless finite
  explicit Rational(const std::string& fraction);  ///< "-3/4" or "12"
  Rational(const Rational&);
  Rational(Rational&&) noexcept;
  Rational& operator=(const Rational&);
  Rational& operator=(Rational&&) noexcept;
  ~Rational();

  Rational& operator+=(const Rational&);
  Rational& operator-=(const Rational&);
  Rational& operator*=(const Rational&);
  Rational& operator/=(const Rational&);  ///< throws std::domain_error on 0
  Rational operator-() const;

  friend Rational operator+(Rational a, const Rational& b) { return a += b; }
  friend Rational operator-(Rational a, const Rational& b) { return a -= b; }
  friend Rational operator*(Rational a, const Rational& b) { return a *= b; }
  friend Rational operator/(Rational a, const Rational& b) { return a /= b; }

  friend bool operator==(const Rational& a, const Rational& b) { return compare(a, b) == 0; }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) { return compare(a, b) <=> 0; }

  int sign() const;
  double nearest() const;           ///< the nearest double (ties to even); ±inf beyond the range
  Interval enclosure() const;       ///< the tightest pair of doubles around it (lo = hi if it is a double)
  Interval sqrt_enclosure() const;  ///< tightest doubles around the square root; throws std::domain_error if negative
  std::string text() const;         ///< "num/den", or "num"

  struct Impl;  ///< holds the GMP number; complete only inside reference/ (reference/exact/rational.h)
  const Impl& impl() const { return *impl_; }
  explicit Rational(std::unique_ptr<Impl> impl);

 private:
  static int compare(const Rational& a, const Rational& b);
  std::unique_ptr<Impl> impl_;
};

/// Three components, exactly.
struct RationalVec3 {
  Rational x, y, z;

  bool operator==(const RationalVec3&) const = default;
};

}  // namespace touchstone::reference
