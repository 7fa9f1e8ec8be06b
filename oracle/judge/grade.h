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
///   D  beyond: an absolute epsilon, a wrong formula or a broken law; failures without a magnitude; a refusal
///   F  no answer (threw, crashed, hung, garbage, NaN), a verdict or pair wrong by more than C's margin, or an answer
///      that is plainly wrong
/// An answer is plainly wrong if its error is beyond B, is as large as the exact value (0 for 0.83 m) or turns the
/// verdict, and, of a length, is more than 2⁻¹⁰ of the smaller body. For where the exact value is 2ᵏ times what is
/// allowed, the answer has k bits to lose: an error as large as the value loses them all. With k ≤ 10 the clause
/// promised no more than B forgives. So C's six digits are not granted to an engine that computes with seven; and an
/// error of less than a thousandth of a body, the share that B forgives of rounding, does not show.
enum class Grade { A, A_minus, B, C, D, F };

inline constexpr std::size_t grade_count = 6;

/// Requires an outcome that is neither `abstains` nor `outside`: without an answer there is no grade.
Grade grade(const Finding& finding);

std::string name_of(Grade grade);

}  // namespace touchstone::oracle
