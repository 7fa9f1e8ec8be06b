#include "reference/exact_pose_impl.h"
#include "reference/rational_impl.h"
#include "reference/square_root_impl.h"

namespace touchstone::reference {
namespace {

bool is_square(const mpq_class& x) {
  return mpz_perfect_square_p(x.get_num_mpz_t()) != 0 && mpz_perfect_square_p(x.get_den_mpz_t()) != 0;
}

}  // namespace

// √(n/d) = √(n·d)/d, in fixed point with `bits` bits.
mpq_class root_below(const mpq_class& x, unsigned long bits) {
  if (is_square(x)) return mpq_class(sqrt(x.get_num()), sqrt(x.get_den()));
  mpz_class square = x.get_num() * x.get_den();
  square <<= 2 * bits;
  mpq_class root(sqrt(square), x.get_den());
  root.get_den() <<= bits;
  root.canonicalize();
  return root;
}

// √x is irrational or exact, so √x − r is no double unless it is exact: more bits make both roundings certain.
Interval enclosure_of_root_minus(const Rational& x, const Rational& r) {
  const mpq_class& square = x.impl().value;
  if (is_square(square)) return (rational(root_below(square, 0)) - r).enclosure();
  for (unsigned long bits = 128;; bits *= 2) {
    const mpq_class below = root_below(square, bits);
    mpq_class width(1, square.get_den());
    width.get_den() <<= bits;
    width.canonicalize();
    const Interval lower = (rational(below) - r).enclosure();
    const Interval upper = (rational(mpq_class(below + width)) - r).enclosure();
    if (lower.lo == upper.lo && lower.hi == upper.hi) return lower;
  }
}

Interval enclosure_of_minus_root(const Rational& r, const Rational& x) {
  const Interval i = enclosure_of_root_minus(x, r);
  return {-i.hi, -i.lo};
}

// With c ≥ 0: √x < √y + c exactly when x − y − c² < 2c√y. With c < 0 the roles of x and y change.
int compare_roots(const Rational& x, const Rational& y, const Rational& c) {
  if (c.sign() < 0) return -compare_roots(y, x, -c);
  const Rational left = x - y - c * c;
  if (left.sign() < 0) return -1;
  const Rational difference = left * left - Rational(4.0) * c * c * y;
  return difference.sign();
}

}  // namespace touchstone::reference
