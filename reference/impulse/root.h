// Square roots, and directions that need one, in exact arithmetic; throws where they are irrational.
#pragma once

#include <gmpxx.h>

#include "reference/exact/double_double.h"
#include "reference/exact/float.h"
#include "reference/impulse/law.h"

namespace touchstone::reference {

/// Thrown where the solution leaves the rationals; reference/impulse.cpp then solves in floats.
struct Irrational {};

inline mpq_class root(const mpq_class& x) {
  if (!mpz_perfect_square_p(x.get_num_mpz_t()) || !mpz_perfect_square_p(x.get_den_mpz_t())) throw Irrational();
  return {sqrt(x.get_num()), sqrt(x.get_den())};
}

inline Float root(const Float& x) { return sqrt(x); }
inline DoubleDouble root(const DoubleDouble& x) { return sqrt(x); }

/// The tangential direction, of length μ ν, in which slip leaves 0 if the contact does not stick.
inline Three<mpq_class> diverging(const ImpactProblem<mpq_class>& problem, const Three<mpq_class>& sticking) {
  if (!problem.facts.rest_turns) throw Irrational();
  return scaled(root(mpq_class(problem.cone / inner(sticking, sticking))), sticking);
}

}  // namespace touchstone::reference
