#include "app/baseline/comparison.h"

#include <fmt/format.h>

#include <algorithm>

namespace touchstone::app {
namespace {

using oracle::Defect;
using oracle::Grade;

const KnownFailure* find(const Baseline& baseline, const Row& row, Defect cause) {
  const auto same = std::ranges::find_if(baseline.failures, [&](const KnownFailure& known) {
    return known.subject == row.subject->card.name && known.property == row.property->id && known.cause == cause;
  });
  return same == baseline.failures.end() ? nullptr : &*same;
}

std::string words_of(const Waiver& waiver) { return fmt::format("{} ({})", waiver.reason, waiver.link); }

/// Why the failure is accepted.
std::string acceptance(const KnownFailure& known) {
  const std::string words = fmt::format("{}, grade {}", oracle::name_of(known.cause), oracle::name_of(known.grade));
  return known.waiver
             ? fmt::format("{}, waived until {}: {}", words, text_of(known.waiver->expires), words_of(*known.waiver))
             : words + ", in the baseline";
}

void judge_failure(Row& row, Defect cause, Grade grade, const KnownFailure* known, Date today, Comparison& counts) {
  const std::string name = oracle::name_of(cause);
  if (known == nullptr) {
    ++counts.fresh;
    row.baseline.departures.push_back(fmt::format("new: {}, grade {}", name, oracle::name_of(grade)));
  } else if (grade > known->grade) {
    ++counts.worse;
    row.baseline.departures.push_back(fmt::format("worse: {}, grade {}; in the baseline {}", name,
                                                  oracle::name_of(grade), oracle::name_of(known->grade)));
  } else if (known->waiver && known->waiver->expires < today) {
    ++counts.expired;
    row.baseline.departures.push_back(fmt::format("the waiver for {} expired on {}: {}", name,
                                                  text_of(known->waiver->expires), words_of(*known->waiver)));
  } else {
    ++counts.known;
    counts.waived += known->waiver ? 1 : 0;
    row.baseline.known += (row.baseline.known.empty() ? "" : "; ") + acceptance(*known);
  }
}

/// The row that was answered under the property, by the subject.
Row* answered_row(const KnownFailure& known, Ledger& ledger) {
  for (Row& row : ledger.results.all()) {
    if (row.property->id == known.property && row.subject->card.name == known.subject) {
      return row.answered() > 0 ? &row : nullptr;
    }
  }
  return nullptr;
}

void judge_absence(const KnownFailure& known, Ledger& ledger, Comparison& counts) {
  Row* row = answered_row(known, ledger);
  if (row == nullptr) {
    ++counts.not_asked;
  } else if (!row->defects.contains(known.cause)) {
    ++counts.passing;
    row->baseline.departures.push_back(fmt::format("passes, though a failure is expected: {}, grade {}{}",
                                                   oracle::name_of(known.cause), oracle::name_of(known.grade),
                                                   known.waiver ? ", waived: " + words_of(*known.waiver) : ""));
  }
}

}  // namespace

Comparison compare(const Baseline& baseline, Date today, Ledger& ledger) {
  Comparison counts;
  for (Row& row : ledger.results.all()) {
    for (const auto& [cause, grade] : row.worst_grades) {
      judge_failure(row, cause, grade, find(baseline, row, cause), today, counts);
    }
  }
  for (const KnownFailure& known : baseline.failures) judge_absence(known, ledger, counts);
  for (Row& row : ledger.results.all()) {
    if (!row.baseline.departures.empty()) row.baseline.known.clear();
  }
  return counts;
}

}  // namespace touchstone::app
