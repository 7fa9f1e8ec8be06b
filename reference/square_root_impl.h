// Exact statements about √x ± r for rational x and r.
#pragma once

#include <gmpxx.h>

#include "reference/rational.h"

namespace touchstone::reference {

/// √x rounded down to about `bits` bits (exact if x is the square of a rational).
mpq_class root_below(const mpq_class& x, unsigned long bits);

/// The tightest doubles around √x − r, or around r − √x.
Interval enclosure_of_root_minus(const Rational& x, const Rational& r);
Interval enclosure_of_minus_root(const Rational& r, const Rational& x);

/// The sign of √x − √y − c.
int compare_roots(const Rational& x, const Rational& y, const Rational& c);

}  // namespace touchstone::reference
