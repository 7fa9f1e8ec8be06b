#include "app/trial/causes.h"

#include <cctype>
#include <map>
#include <utility>

namespace touchstone::app {
namespace {

/// Indices and coordinates differ from scene to scene.
std::string without_numbers(const std::string& words) {
  std::string same;
  for (const char c : words) {
    const bool digit = std::isdigit(static_cast<unsigned char>(c)) != 0;
    if (!digit) same += c;
    if (digit && (same.empty() || same.back() != '#')) same += '#';
  }
  return same;
}

}  // namespace

std::vector<Cause> causes(const Ledger& ledger) {
  std::vector<Cause> all;
  for (const TestedSubject& subject : ledger.subjects) {
    std::map<std::pair<oracle::Defect, std::string>, std::size_t> known;  // break -> index into `all`
    for (const Row* row : ledger.results.of(subject)) {
      if (!row->failing()) continue;
      const oracle::Finding& finding = shown_finding(*row);
      const auto next = all.size();
      const bool breaks = finding.outcome == oracle::Outcome::breaks;
      const std::size_t at =
          breaks ? known.try_emplace({finding.defect, without_numbers(finding.why)}, next).first->second : next;
      if (at == next) all.push_back({&subject, {}});
      all[at].rows.push_back(row);
    }
  }
  return all;
}

}  // namespace touchstone::app
