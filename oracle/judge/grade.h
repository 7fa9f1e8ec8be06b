// The severity of a finding as a school grade, so that a table of failing rows says more than pass or fail.
#pragma once

#include <cstddef>
#include <string>

#include "oracle/finding.h"

namespace touchstone::oracle {

/// With e = error/allowed (allowed: at least one unit, so that a bound of 0 can be graded too), and s the share of the
/// exact value that the error is; for a length, of the smaller body if that is less:
///   A  holds
///   A- on the side that the clause forbids, but within rounding: a box that is not rounded outward
///   B  e ≤ 2¹⁰: up to three decimal digits lost beyond what rounding explains; and s ≤ 2⁻¹⁰: three digits are right
///   C  e ≤ 2²⁰: up to six; and s ≤ 1/10: one digit is right
///   D  beyond: an absolute epsilon, a wrong formula or a broken law; failures without a magnitude; a refusal
///   F  no answer (threw, crashed, hung, garbage, NaN), a verdict or pair wrong by more than C's margin, s > 1/2 (not
///      the first bit is right), or an answer that is plainly wrong
/// A limit of s counts where at most half of the error is rounding (e ≥ 2), and where the clause promises those digits:
/// for B three (it allows at most 2⁻¹⁰ of the value), else one (at most 1/10). So the grade of a well-conditioned
/// answer does not depend on how wide a worst-case allowance is, and an answer that rounding can spoil is excused. A
/// wrong verdict has no right digit, so that its s is the share of the body. An answer is plainly wrong if its error is
/// beyond B by e, is as large as the exact value (0 for 0.83 m) or turns the verdict, and, of a length, is more than
/// 2⁻¹⁰ of the smaller body, however far the two are from the origin.
enum class Grade { A, A_minus, B, C, D, F };

inline constexpr std::size_t grade_count = 6;

/// Requires an outcome that is neither `abstains` nor `outside`: without an answer there is no grade.
Grade grade(const Finding& finding);

std::string name_of(Grade grade);

}  // namespace touchstone::oracle
