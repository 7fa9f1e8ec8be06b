#include "reference/rational.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "model/infinity.h"
#include "reference/exact/rational.h"

namespace touchstone::reference {
namespace {

mpq_class finite(double x) {
  if (!std::isfinite(x)) throw std::invalid_argument("a rational is finite");
  return mpq_class(x);
}

mpq_class parsed(const std::string& fraction) {
  mpq_class value;
  if (value.set_str(fraction, 10) != 0 || value.get_den() == 0) {
    throw std::invalid_argument("not a fraction: \"" + fraction + "\"");
  }
  value.canonicalize();
  return value;
}

/// The neighbouring doubles around q. mpq_get_d truncates towards 0, including denormals.
Interval around(const mpq_class& q) {
  const double truncated = q.get_d();
  if (std::isinf(truncated)) {
    constexpr double max = std::numeric_limits<double>::max();
    return truncated > 0 ? Interval{max, infinity} : Interval{-infinity, -max};
  }
  const int order = cmp(mpq_class(truncated), q);
  if (order == 0) return {truncated, truncated};
  const double beyond = std::nextafter(truncated, order < 0 ? infinity : -infinity);
  return order < 0 ? Interval{truncated, beyond} : Interval{beyond, truncated};
}

bool has_even_mantissa(double x) {
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  const int bits = std::min(53, exponent + 1074);  // fewer for a denormal
  return bits <= 0 || std::fmod(std::ldexp(mantissa, bits), 2) == 0;
}

/// 2^exponent · q, exactly.
mpq_class scaled_by_power_of_two(mpq_class q, long exponent) {
  if (exponent >= 0) {
    mpq_mul_2exp(q.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
  } else {
    mpq_div_2exp(q.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
  }
  return q;
}

}  // namespace

double nearest(const mpq_class& q) {
  const Interval near = around(q);
  if (near.lo == near.hi) return near.lo;
  // The half-way point between the greatest double and the next power of two decides overflow; ±inf represents that
  // power.
  const auto finite_end = [](double x) {
    return std::isinf(x) ? mpq_class(x > 0 ? scaled_by_power_of_two(mpq_class(1), 1024)
                                           : mpq_class(-scaled_by_power_of_two(mpq_class(1), 1024)))
                         : mpq_class(x);
  };
  const mpq_class middle = (finite_end(near.lo) + finite_end(near.hi)) / 2;
  const int order = cmp(q, middle);
  if (order != 0) return order < 0 ? near.lo : near.hi;
  if (std::isinf(near.lo) || std::isinf(near.hi)) return std::isinf(near.lo) ? near.lo : near.hi;
  return has_even_mantissa(near.lo) ? near.lo : near.hi;
}

Rational::Rational() : impl_(std::make_unique<Impl>()) {}
Rational::Rational(double exact) : impl_(std::make_unique<Impl>(Impl{finite(exact)})) {}
Rational::Rational(const std::string& fraction) : impl_(std::make_unique<Impl>(Impl{parsed(fraction)})) {}
Rational::Rational(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Rational::Rational(const Rational& other) : impl_(std::make_unique<Impl>(*other.impl_)) {}
Rational::Rational(Rational&&) noexcept = default;
Rational& Rational::operator=(const Rational& other) {
  if (this != &other) impl_ = std::make_unique<Impl>(*other.impl_);
  return *this;
}
Rational& Rational::operator=(Rational&&) noexcept = default;
Rational::~Rational() = default;

Rational& Rational::operator+=(const Rational& b) {
  impl_->value += b.impl_->value;
  return *this;
}

Rational& Rational::operator-=(const Rational& b) {
  impl_->value -= b.impl_->value;
  return *this;
}

Rational& Rational::operator*=(const Rational& b) {
  impl_->value *= b.impl_->value;
  return *this;
}

Rational& Rational::operator/=(const Rational& b) {
  if (b.sign() == 0) throw std::domain_error("division by 0");
  impl_->value /= b.impl_->value;
  return *this;
}

Rational Rational::operator-() const { return rational_of(-impl_->value); }

int Rational::compare(const Rational& a, const Rational& b) { return cmp(a.impl_->value, b.impl_->value); }

int Rational::sign() const { return sgn(impl_->value); }

double Rational::nearest() const { return reference::nearest(impl_->value); }

Interval Rational::enclosure() const { return around(impl_->value); }

Interval Rational::sqrt_enclosure() const {
  const mpq_class& q = impl_->value;
  if (sgn(q) < 0) throw std::domain_error("square root of a negative number");
  if (sgn(q) == 0) return {0, 0};
  // Scales q to near 1 by an even power of two, guesses, then steps exactly to the neighbours that enclose the root.
  const long bits =
      static_cast<long>(mpz_sizeinbase(q.get_num_mpz_t(), 2)) - static_cast<long>(mpz_sizeinbase(q.get_den_mpz_t(), 2));
  const long even = bits - (bits % 2);
  double lo = std::ldexp(std::sqrt(scaled_by_power_of_two(q, -even).get_d()), static_cast<int>(even / 2));
  if (std::isinf(lo)) return {std::numeric_limits<double>::max(), infinity};
  const auto square = [](double x) { return mpq_class(mpq_class(x) * mpq_class(x)); };
  while (lo > 0 && square(lo) > q) lo = std::nextafter(lo, 0);
  for (double hi = std::nextafter(lo, infinity);; lo = hi, hi = std::nextafter(lo, infinity)) {
    if (square(lo) == q) return {lo, lo};
    if (std::isinf(hi) || square(hi) > q) return {lo, hi};
  }
}

std::string Rational::text() const { return impl_->value.get_str(); }

}  // namespace touchstone::reference
