// The GMP number inside a Rational. Only files of reference/ include this.
#pragma once

#include <gmpxx.h>

#include <memory>
#include <utility>

#include "reference/rational.h"

namespace touchstone::reference {

struct Rational::Impl {
  mpq_class value;
};

inline const mpq_class& value_of(const Rational& r) { return r.impl().value; }

/// The double nearest to q (ties to even). Requires a positive denominator, not lowest terms.
double nearest(const mpq_class& q);

/// Reduces the value to lowest terms.
inline Rational rational_of(mpq_class value) {
  value.canonicalize();
  return Rational(std::make_unique<Rational::Impl>(Rational::Impl{std::move(value)}));
}

}  // namespace touchstone::reference
