#include "app/trend/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "app/system/terminal.h"
#include "app/trial/row.h"
#include "model/input_error.h"

namespace touchstone::app {
namespace {

/// What a subject's answers to one query came to.
struct QuerySummary {
  int answered = 0;   ///< properties
  int hold = 0;       ///< properties
  long answers = 0;   ///< scenes, of all properties
  long failures = 0;  ///< likewise
  std::optional<oracle::Grade> worst;

  void add(const ReportedRow& row) {
    if (row.answered() == 0) return;
    ++answered;
    hold += row.failures == 0 ? 1 : 0;
    answers += row.answered();
    failures += row.failures;
    worst = std::max(worst, row.grade);
  }
};

std::string text_of(const QuerySummary& query) {
  if (query.answered == 0) return "";
  const std::string properties = fmt::format("{} of {}", query.hold, query.answered);
  if (query.failures == 0) return properties;
  return fmt::format("{}; {} {}", properties, percent(query.failures, query.answers), oracle::name_of(*query.worst));
}

template <class T>
void add_if_new(std::vector<T>& all, const T& one) {
  if (std::ranges::find(all, one) == all.end()) all.push_back(one);
}

}  // namespace

std::string summary_of(const ReportFile& report, const std::vector<std::string>& named) {
  std::vector<std::string> queries, subjects = named;
  for (const std::string& name : named) {
    if (!report.versions.contains(name)) throw InputError(report.path, "has no subject " + name);
  }
  std::map<std::string, std::map<std::string, QuerySummary>> summaries;  // by subject and query
  for (const ReportedRow& row : report.rows) {
    const std::string query = row.property.substr(0, row.property.find('.'));
    add_if_new(queries, query);
    if (named.empty() && row.answered() > 0) add_if_new(subjects, row.subject);
    summaries[row.subject][query].add(row);
  }
  std::string table = "| properties that hold; wrong answers, worst grade |";
  for (const std::string& query : queries) table += fmt::format(" {} |", query);
  table += "\n|---|";
  for (std::size_t q = 0; q < queries.size(); ++q) table += "---|";
  for (const std::string& subject : subjects) {
    table += fmt::format("\n| `{}` {} |", subject, report.versions.at(subject));
    for (const std::string& query : queries) table += fmt::format(" {} |", text_of(summaries[subject][query]));
  }
  return fmt::format("{}\n\n`touchstone report --effort {} --seed {}`: {} drawn scenes a query\n", table, report.effort,
                     report.seed, report.cases);
}

void summarise(const std::string& path, const std::vector<std::string>& subjects) {
  print_lines(summary_of(read_report(path), subjects));
}

}  // namespace touchstone::app
