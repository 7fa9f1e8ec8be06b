#include "fast/exact/dyadic.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace touchstone::fast::exact {
namespace {

constexpr int limb_bits = 64;

__extension__ using Product = unsigned __int128;  // of two limbs

/// A magnitude on a common scale: its lowest limb has the weight of limb `shift` there, its highest that of `end` − 1.
struct Aligned {
  Aligned(const Limbs& of, long from)
      : limbs(of.data()), size(of.size()), shift(static_cast<std::size_t>(from)), end(shift + size) {}

  const std::uint64_t* limbs;
  std::size_t size, shift, end;
};

/// Neither is 0, so their highest limbs are not, and neither are their lowest.
int compare(const Aligned& x, const Aligned& y) {
  if (x.end != y.end) return x.end < y.end ? -1 : 1;
  std::size_t i = x.size, j = y.size;
  while (i > 0 && j > 0) {
    const std::uint64_t a = x.limbs[--i], b = y.limbs[--j];
    if (a != b) return a < b ? -1 : 1;
  }
  return i > 0 ? 1 : j > 0 ? -1 : 0;
}

/// The limbs of z, which become those of x.
std::uint64_t* copy(const Aligned& x, std::size_t size, Limbs& z) {
  z.reset(size);
  std::uint64_t* limbs = z.data();
  for (std::size_t i = 0; i < x.shift; ++i) limbs[i] = 0;
  for (std::size_t i = 0; i < x.size; ++i) limbs[x.shift + i] = x.limbs[i];
  for (std::size_t i = x.end; i < size; ++i) limbs[i] = 0;
  return limbs;
}

/// z: x + y.
void add(const Aligned& x, const Aligned& y, Limbs& z) {
  std::uint64_t* limbs = copy(x, std::max(x.end, y.end) + 1, z) + y.shift;
  Product carry = 0;
  for (std::size_t i = 0; i < y.size; ++i) {
    carry += Product{limbs[i]} + y.limbs[i];
    limbs[i] = static_cast<std::uint64_t>(carry);
    carry >>= limb_bits;
  }
  for (limbs += y.size; carry != 0; ++limbs) carry = ++*limbs == 0 ? 1 : 0;
}

/// z: x − y. Requires x > y.
void subtract(const Aligned& x, const Aligned& y, Limbs& z) {
  std::uint64_t* limbs = copy(x, x.end, z) + y.shift;
  std::uint64_t borrow = 0;
  for (std::size_t i = 0; i < y.size; ++i) {
    const Product difference = Product{limbs[i]} - y.limbs[i] - borrow;
    limbs[i] = static_cast<std::uint64_t>(difference);
    borrow = difference >> limb_bits != 0 ? 1 : 0;
  }
  for (limbs += y.size; borrow != 0; ++limbs) borrow = (*limbs)-- == 0 ? 1 : 0;
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
  limbs_.reset(2);
  limbs_.data()[0] = mantissa << shift;
  limbs_.data()[1] = shift == 0 ? 0 : mantissa >> (limb_bits - shift);
  trim();
}

void Dyadic::trim() {
  const std::uint64_t* limbs = limbs_.data();
  std::size_t first = 0, end = limbs_.size();
  while (end > 0 && limbs[end - 1] == 0) --end;
  while (first < end && limbs[first] == 0) ++first;
  lowest_ += static_cast<long>(first);
  limbs_.cut(first, end - first);
  if (limbs_.empty()) sign_ = 0;
}

Dyadic Dyadic::operator-() const {
  Dyadic z = *this;
  z.sign_ = -sign_;
  return z;
}

Dyadic Dyadic::sum(const Dyadic& x, const Dyadic& y, int sign_of_y) {
  if (sign_of_y == 0) return x;
  if (x.sign_ == 0) return sign_of_y == y.sign_ ? y : -y;
  return sum_of_others(x, y, sign_of_y);
}

/// Of numbers that are not 0. It returns one variable alone, which is made where the caller wants it: to copy what was
/// written just before is slow.
Dyadic Dyadic::sum_of_others(const Dyadic& x, const Dyadic& y, int sign_of_y) {
  Dyadic z;
  z.lowest_ = std::min(x.lowest_, y.lowest_);
  const Aligned a(x.limbs_, x.lowest_ - z.lowest_);
  const Aligned b(y.limbs_, y.lowest_ - z.lowest_);
  if (x.sign_ == sign_of_y) {
    z.sign_ = x.sign_;
    add(a, b, z.limbs_);
  } else {
    const int order = compare(a, b);
    z.sign_ = order > 0 ? x.sign_ : sign_of_y;
    if (order > 0) subtract(a, b, z.limbs_);
    if (order < 0) subtract(b, a, z.limbs_);
  }
  z.trim();
  return z;
}

Dyadic operator*(const Dyadic& x, const Dyadic& y) {
  Dyadic z;
  z.sign_ = x.sign_ * y.sign_;
  if (z.sign_ == 0) return z;
  z.lowest_ = x.lowest_ + y.lowest_;
  z.limbs_.reset(x.limbs_.size() + y.limbs_.size());
  const std::uint64_t *a = x.limbs_.data(), *b = y.limbs_.data();
  std::uint64_t* limbs = z.limbs_.data();
  const std::size_t size = y.limbs_.size();
  for (std::size_t j = 0; j < size; ++j) limbs[j] = 0;
  for (const std::uint64_t* end = a + x.limbs_.size(); a != end; ++a, ++limbs) {
    Product carry = 0;
    for (std::size_t j = 0; j < size; ++j) {
      carry += Product{*a} * b[j] + limbs[j];
      limbs[j] = static_cast<std::uint64_t>(carry);
      carry >>= limb_bits;
    }
    limbs[size] = static_cast<std::uint64_t>(carry);
  }
  z.trim();
  return z;
}

Dyadic::Scientific Dyadic::scientific() const {
  if (sign_ == 0) return {};
  // The two highest limbs have at least 65 bits; those beyond the first 53 are truncated.
  const std::uint64_t* top = limbs_.data() + limbs_.size() - 1;
  const int zeros = std::countl_zero(*top);
  const std::uint64_t next = zeros == 0 || limbs_.size() == 1 ? 0 : top[-1] >> (limb_bits - zeros);
  const std::uint64_t mantissa = (*top << zeros | next) >> 11;
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
