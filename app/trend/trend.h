// What changed between two reports: two versions of an engine, or two of its settings.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/trend/report_file.h"

namespace touchstone::app {

/// `fresh` fails now and did not before; `silent` does not answer any more.
enum class Change { fresh, worse, silent, better, fixed, answers };

std::string name_of(Change change);

/// A row that changed.
struct ChangedRow {
  Change change = Change::fresh;
  const ReportedRow* before = nullptr;  ///< null if it was not asked
  const ReportedRow* after = nullptr;   ///< null if it was not asked
};

/// Of the rows that two subjects have in common.
struct Trend {
  std::string before, after;        ///< the subjects' names
  std::vector<ChangedRow> changes;  ///< by kind, and then as in the new report
  long holds = 0;                   ///< rows that hold in both
  long fails = 0;                   ///< rows that fail in both, with the same grade and as often
  long unanswered = 0;              ///< rows that neither answers

  bool regressed() const;
};

/// One trend for each pair of subjects, old name -> new name. A row that fails in both is worse or better by its grade;
/// if the grades are equal and the reports asked the same scenes, by the number of scenes on which it fails. The
/// reports must outlive the result.
std::vector<Trend> trends(const ReportFile& before, const ReportFile& after,
                          const std::map<std::string, std::string>& pairs);

}  // namespace touchstone::app
