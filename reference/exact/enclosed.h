// Interval arithmetic of 254 bits: every result encloses the exact one. For closed forms whose signs must be certain.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>

#include "model/frame.h"
#include "reference/exact/float.h"

namespace touchstone::reference {

/// Thrown when two numbers cannot be distinguished: the caller's question has no certain answer.
class Undecided : public std::runtime_error {
 public:
  explicit Undecided(const std::string& what) : std::runtime_error(what) {}
};

/// A closed interval that holds one real number. A number that a Float represents is a point interval. Sums and
/// products of points stay points if they fit, so what is exactly 0 in a scene stays exactly 0.
class Enclosed {
 public:
  Enclosed() : Enclosed(0) {}
  Enclosed(int n) : lo_(n), hi_(n) {}     // NOLINT: as Float does
  Enclosed(double x) : lo_(x), hi_(x) {}  // NOLINT
  Enclosed(const mpq_class& q) {          // NOLINT
    mpfr_set_q(at(lo_), q.get_mpq_t(), MPFR_RNDD);
    mpfr_set_q(at(hi_), q.get_mpq_t(), MPFR_RNDU);
  }
  explicit Enclosed(const Float& x) : lo_(x), hi_(x) {}
  Enclosed(Float lo, Float hi) : lo_(std::move(lo)), hi_(std::move(hi)) {}

  const Float& lo() const { return lo_; }
  const Float& hi() const { return hi_; }
  Float width() const { return hi_ - lo_; }
  Float middle() const { return lo_ + (hi_ - lo_) / 2; }

  bool is_zero() const { return lo_ == 0 && hi_ == 0; }
  bool holds_zero() const { return lo_ <= 0 && hi_ >= 0; }
  bool is_positive() const { return lo_ > 0; }
  bool is_negative() const { return hi_ < 0; }

  /// Rounded outward to doubles.
  Interval in_doubles() const {
    return {mpfr_get_d(lo_.backend().data(), MPFR_RNDD), mpfr_get_d(hi_.backend().data(), MPFR_RNDU)};
  }

  friend Enclosed operator-(const Enclosed& a) { return {-a.hi_, -a.lo_}; }
  friend Enclosed operator+(const Enclosed& a, const Enclosed& b) {
    Enclosed c;
    mpfr_add(at(c.lo_), at(a.lo_), at(b.lo_), MPFR_RNDD);
    mpfr_add(at(c.hi_), at(a.hi_), at(b.hi_), MPFR_RNDU);
    return c;
  }
  friend Enclosed operator-(const Enclosed& a, const Enclosed& b) { return a + -b; }
  friend Enclosed operator*(const Enclosed& a, const Enclosed& b) {
    if (a.is_zero() || b.is_zero()) return {};
    if (a.lo_ >= 0) return product(b.lo_ >= 0 ? a.lo_ : a.hi_, b.lo_, b.hi_ >= 0 ? a.hi_ : a.lo_, b.hi_);
    if (a.hi_ <= 0) return -(-a * b);
    if (b.lo_ >= 0 || b.hi_ <= 0) return b * a;
    return hull(product(a.lo_, b.hi_, a.lo_, b.lo_), product(a.hi_, b.lo_, a.hi_, b.hi_));
  }
  /// Throws Undecided if b may be 0.
  friend Enclosed operator/(const Enclosed& a, const Enclosed& b) {
    if (b.holds_zero()) throw Undecided("a divisor that may be 0");
    Enclosed inverse;
    mpfr_ui_div(at(inverse.lo_), 1, at(b.hi_), MPFR_RNDD);
    mpfr_ui_div(at(inverse.hi_), 1, at(b.lo_), MPFR_RNDU);
    return a * inverse;
  }

  friend Enclosed hull(const Enclosed& a, const Enclosed& b) {
    return {std::min(a.lo_, b.lo_), std::max(a.hi_, b.hi_)};
  }
  /// Of two enclosures of one number: what they have in common.
  friend Enclosed shared(const Enclosed& a, const Enclosed& b) {
    return {std::max(a.lo_, b.lo_), std::min(a.hi_, b.hi_)};
  }
  friend Enclosed square(const Enclosed& a) {
    const Enclosed product = a * a;
    return a.holds_zero() ? Enclosed(Float(0), product.hi_) : product;
  }
  /// The root of a number that is known to be ≥ 0.
  friend Enclosed root(const Enclosed& a) {
    Enclosed c;
    const Float lo = std::max(a.lo_, Float(0));
    mpfr_sqrt(at(c.lo_), at(lo), MPFR_RNDD);
    mpfr_sqrt(at(c.hi_), at(a.hi_), MPFR_RNDU);
    return c;
  }
  friend Enclosed magnitude(const Enclosed& a) { return a.lo_ >= 0 ? a : a.hi_ <= 0 ? -a : root(square(a)); }

 private:
  static mpfr_ptr at(Float& f) { return f.backend().data(); }
  static mpfr_srcptr at(const Float& f) { return f.backend().data(); }
  /// Returns [a b, c d].
  static Enclosed product(const Float& a, const Float& b, const Float& c, const Float& d) {
    Enclosed result;
    mpfr_mul(at(result.lo_), at(a), at(b), MPFR_RNDD);
    mpfr_mul(at(result.hi_), at(c), at(d), MPFR_RNDU);
    return result;
  }

  Float lo_, hi_;
};

/// Comparisons of the real numbers. They throw Undecided where the enclosures do not decide.
inline bool operator<(const Enclosed& a, const Enclosed& b) {
  if (a.hi() < b.lo()) return true;
  if (a.lo() >= b.hi()) return false;
  throw Undecided("an order");
}
inline bool operator>(const Enclosed& a, const Enclosed& b) { return b < a; }
inline bool operator<=(const Enclosed& a, const Enclosed& b) { return !(b < a); }
inline bool operator>=(const Enclosed& a, const Enclosed& b) { return !(a < b); }
inline bool operator==(const Enclosed& a, const Enclosed& b) {
  if (a.hi() < b.lo() || b.hi() < a.lo()) return false;
  if (a.lo() == a.hi() && b.lo() == b.hi()) return true;
  throw Undecided("an equality");
}

using EnclosedVec = Three<Enclosed>;

inline EnclosedVec shared(const EnclosedVec& a, const EnclosedVec& b) {
  return {shared(a[0], b[0]), shared(a[1], b[1]), shared(a[2], b[2])};
}

/// Returns −1, 0 (for the point 0) or 1. Throws Undecided with the message `what` if the enclosure does not decide.
inline int sign_of(const Enclosed& a, const char* what) {
  if (a.is_zero()) return 0;
  if (a.holds_zero()) throw Undecided(what);
  return a.is_positive() ? 1 : -1;
}

/// Are all three coordinates exactly 0?
inline bool is_zero(const EnclosedVec& a) { return a[0].is_zero() && a[1].is_zero() && a[2].is_zero(); }

}  // namespace touchstone::reference
