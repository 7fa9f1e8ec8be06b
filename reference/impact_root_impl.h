// Square roots, and directions that need one, for an exact course: given up where they are irrational.
#pragma once

#include <gmpxx.h>

#include "reference/double_double_impl.h"
#include "reference/float_impl.h"
#include "reference/impact_law_impl.h"

namespace touchstone::reference {

/// Thrown where a course leaves the rationals; reference/impulse.cpp then walks it in floats.
struct Irrational {};

inline mpq_class root(const mpq_class& x) {
  if (!mpz_perfect_square_p(x.get_num_mpz_t()) || !mpz_perfect_square_p(x.get_den_mpz_t())) throw Irrational();
  return {sqrt(x.get_num()), sqrt(x.get_den())};
}

inline Float root(const Float& x) { return sqrt(x); }
inline DoubleDouble root(const DoubleDouble& x) { return sqrt(x); }

/// The tangential direction, of length μ ν, in which slip leaves 0 if it does not stick.
inline Three<mpq_class> diverging(const Blow<mpq_class>& blow, const Three<mpq_class>& sticking) {
  if (!blow.facts.rest_turns) throw Irrational();
  return scaled(root(mpq_class(blow.cone / inner(sticking, sticking))), sticking);
}

}  // namespace touchstone::reference
