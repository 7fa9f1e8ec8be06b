// The GMP number inside a Rational. Only reference/*.cpp includes this.
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

/// The nearest double (ties to even) of a number that need not be in lowest terms, but has a positive denominator.
double nearest(const mpq_class& q);

/// Canonicalises.
inline Rational rational_of(mpq_class value) {
  value.canonicalize();
  return Rational(std::make_unique<Rational::Impl>(Rational::Impl{std::move(value)}));
}

}  // namespace touchstone::reference
