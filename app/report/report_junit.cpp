#include "app/report/report_junit.h"

#include <fmt/format.h>

#include "app/report/finding_words.h"
#include "app/report/xml.h"

namespace touchstone::app {
namespace {

/// No answer of the row either holds or fails.
bool skipped(const Row& row) { return row.answered() == 0; }

std::string counts(const Row& row) {
  return fmt::format("holds {}, fails {}, breaks {}, abstains {}, outside {}", row.holds, row.fails, row.breaks,
                     row.abstains, row.outside);
}

std::string failure(const Row& row) {
  const oracle::Finding& finding = shown_finding(row);
  std::string words;
  for (const auto& [label, text] : lines_of(finding)) words += label + ": " + text + '\n';
  if (!row.case_file.empty()) words += "case: " + row.case_file + '\n';
  if (!row.replay_command.empty()) words += "replay: " + row.replay_command + '\n';
  return fmt::format("<failure type=\"{}\" message=\"{}\">{}</failure>", oracle::name_of(finding.defect),
                     escaped(counts(row)), escaped(words));
}

std::string test_case(const Row& row) {
  std::string inside;
  if (row.failing()) {
    inside = failure(row);
  } else if (skipped(row)) {
    inside = fmt::format("<skipped message=\"{}\"/>",
                         escaped(row.why_abstains.empty() ? "no scene in the property's domain" : row.why_abstains));
  }
  return fmt::format("    <testcase classname=\"{}\" name=\"{}\">{}</testcase>\n", escaped(row.subject->card.name),
                     escaped(row.property->id), inside);
}

}  // namespace

std::string report_junit(const Ledger& ledger) {
  std::string suites;
  for (const TestedSubject& subject : ledger.subjects) {
    std::string cases;
    int tests = 0;
    int failures = 0;
    int skips = 0;
    for (const Row* row : ledger.results.of(subject)) {
      ++tests;
      failures += row->failing() ? 1 : 0;
      skips += skipped(*row) ? 1 : 0;
      cases += test_case(*row);
    }
    suites += fmt::format(
        "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\">\n{}  </testsuite>\n",
        escaped(subject.card.name), tests, failures, skips, cases);
  }
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"touchstone\">\n" + suites + "</testsuites>\n";
}

}  // namespace touchstone::app
