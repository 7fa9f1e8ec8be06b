#include "fast/exact/dyadic.h"

#include <algorithm>
#include <cmath>

namespace touchstone::fast::exact {
namespace {

using Limbs = std::vector<std::uint32_t>;
constexpr int limb_bits = 32;

/// Two magnitudes on one scale: limb i of either has the weight 2^(32 (lowest + i)); limbs that are not stored are 0.
struct Aligned {
  const Limbs& limbs;
  long shift;
  std::uint32_t operator[](long i) const {
    const long k = i - shift;
    return k < 0 || k >= static_cast<long>(limbs.size()) ? 0 : limbs[static_cast<std::size_t>(k)];
  }
};

int compare(const Aligned& x, const Aligned& y, long size) {
  for (long i = size - 1; i >= 0; --i) {
    if (x[i] != y[i]) return x[i] < y[i] ? -1 : 1;
  }
  return 0;
}

Limbs added(const Aligned& x, const Aligned& y, long size) {
  Limbs z(static_cast<std::size_t>(size) + 1);
  std::uint64_t carry = 0;
  for (long i = 0; i < size; ++i) {
    carry += std::uint64_t{x[i]} + y[i];
    z[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(carry);
    carry >>= limb_bits;
  }
  z.back() = static_cast<std::uint32_t>(carry);
  return z;
}

/// Requires x ≥ y.
Limbs subtracted(const Aligned& x, const Aligned& y, long size) {
  Limbs z(static_cast<std::size_t>(size));
  std::uint64_t borrow = 0;
  for (long i = 0; i < size; ++i) {
    const std::uint64_t difference = std::uint64_t{x[i]} - y[i] - borrow;
    z[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(difference);
    borrow = difference >> 63;
  }
  return z;
}

}  // namespace

Dyadic::Dyadic(double x) {
  if (x == 0) return;
  sign_ = x < 0 ? -1 : 1;
  int exponent = 0;
  const auto mantissa = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::abs(x), &exponent), 53));
  exponent -= 53;
  lowest_ = exponent >= 0 ? exponent / limb_bits : -((limb_bits - 1 - exponent) / limb_bits);
  const int shift = exponent - static_cast<int>(lowest_) * limb_bits;
  const std::uint64_t high = shift == 0 ? 0 : mantissa >> (64 - shift);
  const std::uint64_t low = mantissa << shift;
  limbs_ = {static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(low >> limb_bits),
            static_cast<std::uint32_t>(high)};
  trim();
}

void Dyadic::trim() {
  while (!limbs_.empty() && limbs_.back() == 0) limbs_.pop_back();
  const auto first = std::ranges::find_if(limbs_, [](std::uint32_t limb) { return limb != 0; });
  lowest_ += first - limbs_.begin();
  limbs_.erase(limbs_.begin(), first);
  if (limbs_.empty()) sign_ = 0;
}

Dyadic Dyadic::operator-() const {
  Dyadic z = *this;
  z.sign_ = -sign_;
  return z;
}

Dyadic Dyadic::sum(const Dyadic& x, const Dyadic& y, int sign_of_y) {
  if (sign_of_y == 0) return x;
  Dyadic z;
  if (x.sign_ == 0) {
    z = y;
    z.sign_ = sign_of_y;
    return z;
  }
  z.lowest_ = std::min(x.lowest_, y.lowest_);
  const Aligned a{x.limbs_, x.lowest_ - z.lowest_};
  const Aligned b{y.limbs_, y.lowest_ - z.lowest_};
  const long size =
      std::max(a.shift + static_cast<long>(x.limbs_.size()), b.shift + static_cast<long>(y.limbs_.size()));
  if (x.sign_ == sign_of_y) {
    z.sign_ = x.sign_;
    z.limbs_ = added(a, b, size);
  } else {
    const int order = compare(a, b, size);
    if (order == 0) return {};
    z.sign_ = order > 0 ? x.sign_ : sign_of_y;
    z.limbs_ = order > 0 ? subtracted(a, b, size) : subtracted(b, a, size);
  }
  z.trim();
  return z;
}

Dyadic operator*(const Dyadic& x, const Dyadic& y) {
  Dyadic z;
  z.sign_ = x.sign_ * y.sign_;
  if (z.sign_ == 0) return z;
  z.lowest_ = x.lowest_ + y.lowest_;
  z.limbs_.assign(x.limbs_.size() + y.limbs_.size(), 0);
  for (std::size_t i = 0; i < x.limbs_.size(); ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < y.limbs_.size(); ++j) {
      carry += std::uint64_t{x.limbs_[i]} * y.limbs_[j] + z.limbs_[i + j];
      z.limbs_[i + j] = static_cast<std::uint32_t>(carry);
      carry >>= limb_bits;
    }
    z.limbs_[i + y.limbs_.size()] = static_cast<std::uint32_t>(carry);
  }
  z.trim();
  return z;
}

Dyadic::Scientific Dyadic::scientific() const {
  if (sign_ == 0) return {};
  // The three highest limbs have at least 65 bits; those beyond the first 53 are truncated.
  const auto limb = [&](std::size_t from_top) {
    return from_top <= limbs_.size() ? std::uint64_t{limbs_[limbs_.size() - from_top]} : 0;
  };
  const std::uint64_t top = limb(1) << limb_bits | limb(2);
  int zeros = 0;
  while ((top << zeros >> 63) == 0) ++zeros;
  const std::uint64_t next = zeros == 0 ? 0 : limb(3) >> (limb_bits - zeros);
  const std::uint64_t mantissa = (top << zeros | next) >> 11;
  return {sign_ * std::ldexp(static_cast<double>(mantissa), -53),
          limb_bits * (lowest_ + static_cast<long>(limbs_.size())) - zeros};
}

double Dyadic::approximate() const { return exact::approximate(scientific()); }

double approximate(const Dyadic::Scientific& x) {
  constexpr long beyond = 3000;  // more than the range of doubles
  return std::ldexp(x.m, static_cast<int>(std::clamp(x.exponent, -beyond, beyond)));
}

/// Both are truncated to 53 bits (2u each), and their quotient rounds.
Dyadic::Scientific quotient(const Dyadic& x, const Dyadic& y) {
  const Dyadic::Scientific a = x.scientific(), b = y.scientific();
  return {a.m / b.m, a.exponent - b.exponent};
}

double ratio(const Dyadic& x, const Dyadic& y) { return approximate(quotient(x, y)); }

/// The quotient is off by at most 5u and its root by half of that; the root rounds.
double root_of_ratio(const Dyadic& x, const Dyadic& y) {
  const Dyadic::Scientific square = quotient(x, y);
  const bool is_odd = square.exponent % 2 != 0;
  return approximate({std::sqrt((is_odd ? 2 : 1) * square.m), (square.exponent - (is_odd ? 1 : 0)) / 2});
}

}  // namespace touchstone::fast::exact
