// A float of 76 digits (254 bits, four words), and its conversions from and to exact rationals.
#pragma once

#include <gmpxx.h>

#include <boost/multiprecision/mpfr.hpp>

#include "reference/exact/linear.h"

namespace touchstone::reference {

using Float =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<76, boost::multiprecision::allocate_stack>,
                                  boost::multiprecision::et_off>;

inline Float float_of(const mpq_class& q) {
  Float f;
  mpfr_set_q(f.backend().data(), q.get_mpq_t(), MPFR_RNDN);
  return f;
}

inline Three<Float> float_of(const Three<mpq_class>& a) { return {float_of(a[0]), float_of(a[1]), float_of(a[2])}; }

inline Square<Float> float_of(const Square<mpq_class>& M) { return {float_of(M[0]), float_of(M[1]), float_of(M[2])}; }

inline mpq_class exact_of(const Float& f) {
  mpq_class q;
  mpfr_get_q(q.get_mpq_t(), f.backend().data());
  return q;
}

inline Three<mpq_class> exact_of(const Three<Float>& a) { return {exact_of(a[0]), exact_of(a[1]), exact_of(a[2])}; }

}  // namespace touchstone::reference
