// The severity of a finding as a school grade, so that a table of failing rows says more than pass or fail.
#pragma once

#include <cstddef>
#include <string>

#include "oracle/finding.h"

namespace touchstone::oracle {

/// With e = error/allowed (allowed: at least one unit, so that a bound of 0 can be graded too):
///   A  holds
///   A- on the side that the clause forbids, but within rounding: a box that is not rounded outward
///   B  e ≤ 2¹⁰: up to three decimal digits lost beyond what rounding explains
///   C  e ≤ 2²⁰: up to six
///   D  beyond: an absolute epsilon, a wrong formula or a broken law, not rounding; and failures without a magnitude
///   F  no answer (threw, crashed, hung, garbage, NaN), or a verdict or pair wrong by more than C's margin
enum class Grade { A, A_minus, B, C, D, F };

inline constexpr std::size_t grade_count = 6;

/// Requires an outcome that is neither `abstains` nor `outside`: without an answer there is no grade.
Grade grade(const Finding& finding);

std::string name_of(Grade grade);

}  // namespace touchstone::oracle
