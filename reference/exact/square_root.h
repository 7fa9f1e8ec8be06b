// Exact statements about √x ± r for rational x and r.
#pragma once

#include <gmpxx.h>

#include "reference/rational.h"

namespace touchstone::reference {

/// lo ≤ √x ≤ hi, with a relative difference of about 2^-bits; equal if √x is rational.
struct RootBounds {
  mpq_class lo;
  mpq_class hi;
};
RootBounds root_bounds(const mpq_class& x, long bits);

/// The tightest doubles around √x − r, or around r − √x.
Interval enclosure_of_root_minus(const Rational& x, const Rational& r);
Interval enclosure_of_minus_root(const Rational& r, const Rational& x);

/// The sign of √x − √y − c.
int compare_roots(const Rational& x, const Rational& y, const Rational& c);

}  // namespace touchstone::reference
