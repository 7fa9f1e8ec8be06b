#include "reference/exact/square_root.h"

#include "reference/exact/exact_pose.h"
#include "reference/exact/rational.h"

namespace touchstone::reference {
namespace {

bool is_square(const mpq_class& x) {
  return mpz_perfect_square_p(x.get_num_mpz_t()) != 0 && mpz_perfect_square_p(x.get_den_mpz_t()) != 0;
}

}  // namespace

// √(n/d) = √(4^s n/d)/2^s, with s such that the integer root has the required bits.
RootBounds root_bounds(const mpq_class& x, long bits) {
  if (is_square(x)) {
    const mpq_class root(Integer(sqrt(x.get_num())), Integer(sqrt(x.get_den())));
    return {root, root};
  }
  const auto size = [](const Integer& v) { return static_cast<long>(mpz_sizeinbase(v.get_mpz_t(), 2)); };
  const long shift = bits + (size(x.get_den()) - size(x.get_num())) / 2 + 1;
  const Integer scaled = shift >= 0 ? Integer(x.get_num() << static_cast<mp_bitcnt_t>(2 * shift)) : x.get_num();
  const Integer unit = shift >= 0 ? x.get_den() : Integer(x.get_den() << static_cast<mp_bitcnt_t>(-2 * shift));
  const Integer root = sqrt(Integer(scaled / unit));
  return {fraction(root, 1, -shift), fraction(root + 1, 1, -shift)};
}

// An irrational √x is not a double plus r: with enough bits both bounds round to the same neighbours.
Interval enclosure_of_root_minus(const Rational& x, const Rational& r) {
  for (long bits = 128;; bits *= 2) {
    const RootBounds root = root_bounds(x.impl().value, bits);
    const Interval lower = (rational(root.lo) - r).enclosure();
    if (root.lo == root.hi) return lower;
    const Interval upper = (rational(root.hi) - r).enclosure();
    if (lower == upper) return lower;
  }
}

Interval enclosure_of_minus_root(const Rational& r, const Rational& x) {
  const Interval i = enclosure_of_root_minus(x, r);
  return {-i.hi, -i.lo};
}

// With c ≥ 0: √x < √y + c exactly if x − y − c² < 2c√y. With c < 0 the roles of x and y change.
int compare_roots(const Rational& x, const Rational& y, const Rational& c) {
  if (c.sign() < 0) return -compare_roots(y, x, -c);
  const Rational left = x - y - c * c;
  if (left.sign() < 0) return -1;
  const Rational difference = left * left - Rational(4.0) * c * c * y;
  return difference.sign();
}

}  // namespace touchstone::reference
