#include "oracle/judge/grade.h"

#include <algorithm>
#include <array>

namespace touchstone::oracle {
namespace {

bool is_wrong_verdict(Defect defect) { return defect == Defect::phantom || defect == Defect::missed; }

constexpr double three_digits = 0x1p10;

/// Requires a failure with a magnitude.
bool is_plainly_wrong(const Finding& finding) {
  const bool no_digit = is_wrong_verdict(finding.defect) ? finding.of_body.has_value() : finding.relative >= 1.0;
  return no_digit && finding.of_body.value_or(1) * three_digits > 1;
}

}  // namespace

Grade grade(const Finding& finding) {
  if (finding.outcome == Outcome::holds) return Grade::A;
  if (finding.defect == Defect::refused) return Grade::D;
  if (finding.outcome == Outcome::breaks || finding.defect == Defect::not_finite) return Grade::F;
  if (finding.unit == without_size) return Grade::D;
  if (finding.rounding > 0 && finding.error <= finding.rounding) return Grade::A_minus;
  const double e = finding.error / std::max(finding.allowed, 1.0);
  if (e <= three_digits) return Grade::B;
  if (is_plainly_wrong(finding)) return Grade::F;
  if (e <= three_digits * three_digits) return Grade::C;
  return is_wrong_verdict(finding.defect) ? Grade::F : Grade::D;
}

std::string name_of(Grade grade) {
  constexpr std::array<const char*, grade_count> names = {"A", "A-", "B", "C", "D", "F"};
  return names[static_cast<std::size_t>(grade)];
}

}  // namespace touchstone::oracle
