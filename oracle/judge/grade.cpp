#include "oracle/judge/grade.h"

#include <algorithm>
#include <array>

namespace touchstone::oracle {
namespace {

bool is_wrong_verdict(Defect defect) { return defect == Defect::phantom || defect == Defect::missed; }

}  // namespace

Grade grade(const Finding& finding) {
  if (finding.outcome == Outcome::holds) return Grade::A;
  if (finding.outcome == Outcome::breaks || finding.defect == Defect::not_finite) return Grade::F;
  if (finding.unit == without_size) return Grade::D;
  if (finding.rounding > 0 && finding.error <= finding.rounding) return Grade::A_minus;
  const double e = finding.error / std::max(finding.allowed, 1.0);
  if (e <= 0x1p10) return Grade::B;
  if (e <= 0x1p20) return Grade::C;
  return is_wrong_verdict(finding.defect) ? Grade::F : Grade::D;
}

std::string name_of(Grade grade) {
  constexpr std::array<const char*, grade_count> names = {"A", "A-", "B", "C", "D", "F"};
  return names[static_cast<std::size_t>(grade)];
}

}  // namespace touchstone::oracle
