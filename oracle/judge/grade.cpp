#include "oracle/judge/grade.h"

#include <algorithm>
#include <array>

namespace touchstone::oracle {
namespace {

bool is_wrong_verdict(Defect defect) { return defect == Defect::phantom || defect == Defect::missed; }

constexpr double three_digits = 0x1p10;

// 1: the share of the exact value or of the body that the error is, the lesser of the two; 0 if neither is known.
double share(const Finding& finding) {
  const std::optional<double> relative = is_wrong_verdict(finding.defect) ? 1 : finding.relative;
  if (!finding.of_body) return is_wrong_verdict(finding.defect) ? 0 : relative.value_or(0);
  return std::min(relative.value_or(*finding.of_body), *finding.of_body);
}

// The grade that the share s alone calls for.
Grade grade_of_share(double s, double e) {
  const double one_digit = 0.1, allowed = s / e;
  const auto exceeds = [&](double limit) { return s > limit && e >= 2 && allowed <= std::min(limit, one_digit); };
  if (exceeds(0.5)) return Grade::F;
  if (exceeds(one_digit)) return Grade::D;
  return exceeds(1 / three_digits) ? Grade::C : Grade::B;
}

Grade grade_of_excess(double e, Defect defect) {
  if (e <= three_digits) return Grade::B;
  if (e <= three_digits * three_digits) return Grade::C;
  return is_wrong_verdict(defect) ? Grade::F : Grade::D;
}

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
  const double e = excess(finding);
  if (e > three_digits && is_plainly_wrong(finding)) return Grade::F;
  return std::max(grade_of_excess(e, finding.defect), grade_of_share(share(finding), e));
}

std::string name_of(Grade grade) {
  constexpr std::array<const char*, grade_count> names = {"A", "A-", "B", "C", "D", "F"};
  return names[static_cast<std::size_t>(grade)];
}

}  // namespace touchstone::oracle
