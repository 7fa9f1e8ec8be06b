#include "app/trial/unanswered.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace touchstone::app {
namespace {

using Rows = std::vector<Row*>;

bool only_threw_or_refused(const Row& row) {
  return std::ranges::all_of(row.defects, [](const auto& counted) {
    return counted.first == oracle::Defect::threw || counted.first == oracle::Defect::refused;
  });
}

/// No answer, but an abstention; and where there was neither, the subject threw or refused.
bool gives_nothing(const Rows& rows) {
  const auto silent = [](const Row* row) {
    return row->counts.holds + row->counts.fails == 0 && only_threw_or_refused(*row);
  };
  return std::ranges::all_of(rows, silent) &&
         std::ranges::any_of(rows, [](const Row* row) { return row->counts.abstains > 0; });
}

std::string first_reason(const Rows& rows) {
  for (const Row* row : rows) {
    if (!row->why_abstains.empty()) return row->why_abstains;
  }
  return "";
}

void count_as_abstentions(const Rows& rows) {
  const std::string reason = first_reason(rows);
  for (Row* row : rows) {
    const long without_answer = std::exchange(row->counts.breaks, 0) + std::exchange(row->counts.refused, 0);
    if (without_answer == 0) continue;
    const oracle::Finding& worst = row->examples.worst->finding;
    row->why_abstains = fmt::format("{} (on {} other {} it {}: {})", reason, without_answer,
                                    without_answer == 1 ? "scene" : "scenes", oracle::name_of(worst.defect), worst.why);
    row->counts.abstains += without_answer;
    row->grades = {};
    row->defects.clear();
    row->worst_grades.clear();
    row->examples.worst.reset();
    row->examples.smallest.reset();
  }
}

}  // namespace

void count_as_abstentions(ResultMatrix& results) {
  std::map<std::pair<std::size_t, std::string>, Rows> of_queries;
  for (Row& row : results.all()) of_queries[{row.subject->index, row.property->query}].push_back(&row);
  for (const auto& [key, rows] : of_queries) {
    if (gives_nothing(rows)) count_as_abstentions(rows);
    for (Row* row : rows) {
      if (gives_nothing({row})) count_as_abstentions(Rows{row});
    }
  }
}

std::vector<Unanswered> unanswered(const Ledger& ledger) {
  std::vector<Unanswered> all;
  for (const TestedSubject& subject : ledger.subjects) {
    std::map<std::string, long> answers;
    for (const Row* row : ledger.results.of(subject))
      answers[row->property->query] += row->counts.holds + row->counts.fails;
    for (const Row* row : ledger.results.of(subject)) {
      const auto found = answers.find(row->property->query);
      if (found == answers.end()) continue;
      if (found->second == 0) all.push_back({&subject, found->first});
      answers.erase(found);
    }
  }
  return all;
}

}  // namespace touchstone::app
