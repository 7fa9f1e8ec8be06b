#include "app/report/finding_words.h"

#include <fmt/format.h>

namespace touchstone::app {
namespace {

std::string error_of(const oracle::Finding& finding) {
  if (finding.unit.empty()) return "";
  const std::string rounding =
      finding.rounding > 0 ? fmt::format("; rounding explains {:.4g}", finding.rounding) : std::string();
  return fmt::format("{:.4g} {}; allowed {:.4g}{}", finding.error, finding.unit, finding.allowed, rounding);
}

std::string size_of(const oracle::Finding& finding) {
  std::string words;
  if (finding.relative) words = fmt::format("{:.3g} times the exact value", *finding.relative);
  if (finding.of_body) {
    words += fmt::format("{}{:.3g} times the size of the smaller body", words.empty() ? "" : ", ", *finding.of_body);
  }
  return words;
}

std::string margin_of(const oracle::Finding& finding) {
  if (!finding.margin) return "";
  if (finding.margin->hi == 0) return "none: the scene lies exactly between two truths";
  return fmt::format("{:.6g} m from another truth", finding.margin->lo);
}

}  // namespace

std::string outcome_of(const oracle::Finding& finding) {
  const std::string outcome = oracle::name_of(finding.outcome);
  return finding.defect == oracle::Defect::none ? outcome : outcome + ": " + oracle::name_of(finding.defect);
}

Lines lines_of(const oracle::Finding& finding) {
  Lines lines = {{"outcome", outcome_of(finding)}, {"observed", finding.observed}, {"expected", finding.expected},
                 {"error", error_of(finding)},     {"that is", size_of(finding)},  {"margin", margin_of(finding)},
                 {"because", finding.why}};
  std::erase_if(lines, [](const auto& line) { return line.second.empty(); });
  return lines;
}

}  // namespace touchstone::app
