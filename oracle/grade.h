// How badly: a school grade for a finding, so that a table of failing rows says more than red.
#pragma once

#include <string>

#include "oracle/finding.h"

namespace touchstone::oracle {

/// With e = error/allowed (allowed: at least one unit, so that a bound of 0 can be graded too):
///   A  holds
///   B  e ≤ 2¹⁰: up to three decimal digits lost beyond what rounding explains
///   C  e ≤ 2²⁰: up to six
///   D  beyond: an absolute epsilon, a wrong formula or a broken law; no rounding; and whatever has no size
///   F  no answer (threw, crashed, hung, garbage, NaN), or a verdict or pair wrong by more than C's margin
enum class Grade { A, B, C, D, F };

/// Requires an outcome that is neither `abstains` nor `outside`: what was not answered has no grade.
Grade grade(const Finding& finding);

std::string name_of(Grade grade);

}  // namespace touchstone::oracle
