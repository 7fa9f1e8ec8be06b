#include "app/report/report_junit.h"

#include <fmt/format.h>

#include "app/report/finding_words.h"
#include "app/report/xml.h"

namespace touchstone::app {
namespace {

/// No answer of the row either holds or fails, or a baseline has its failures.
bool skipped(const Row& row) { return row.answered() == 0 || !row.baseline.known.empty(); }

/// A row that fails without being known to, or that departs from a baseline: a failure that it has does not occur.
bool red(const Row& row) { return !row.baseline.departures.empty() || (row.failing() && row.baseline.known.empty()); }

std::string counts(const Row& row) {
  return fmt::format("holds {}, fails {}, breaks {}, refused {}, abstains {}, outside {}", row.counts.holds,
                     row.counts.fails, row.counts.breaks, row.counts.refused, row.counts.abstains, row.counts.outside);
}

std::string failure(const Row& row) {
  const oracle::Finding& finding = shown_finding(row);
  std::string words;
  for (const std::string& departure : row.baseline.departures) words += departure + '\n';
  for (const auto& [label, text] : lines_of(finding)) words += label + ": " + text + '\n';
  if (!row.minimised.case_file.empty()) words += "case: " + row.minimised.case_file + '\n';
  if (!row.minimised.replay_command.empty()) words += "replay: " + row.minimised.replay_command + '\n';
  if (row.minimised.result) {
    words += "scene: " + touchstone::json_of(row.minimised.result->scene).dump() + '\n';
    if (const auto& changed = row.minimised.result->changed) {
      words += fmt::format("asked of {}: {}\n", changed->how, touchstone::json_of(changed->scene).dump());
    }
  }
  return fmt::format("<failure type=\"{}\" message=\"{}\">{}</failure>", oracle::name_of(finding.defect),
                     escaped(counts(row)), escaped(words));
}

std::string departure(const Row& row) {
  std::string words;
  for (const std::string& one : row.baseline.departures) words += one + '\n';
  return fmt::format("<failure type=\"passes\" message=\"{}\">{}</failure>", escaped(counts(row)), escaped(words));
}

std::string why_skipped(const Row& row) {
  if (!row.baseline.known.empty()) return "known: " + row.baseline.known;
  return row.why_abstains.empty() ? "no scene in the property's domain" : row.why_abstains;
}

std::string test_case(const Row& row) {
  std::string inside;
  if (red(row)) {
    inside = row.failing() ? failure(row) : departure(row);
  } else if (skipped(row)) {
    inside = fmt::format("<skipped message=\"{}\"/>", escaped(why_skipped(row)));
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
      failures += red(*row) ? 1 : 0;
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
