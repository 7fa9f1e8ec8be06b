// The command compare: what changed between two reports.
#pragma once

#include <string>
#include <vector>

namespace touchstone::app {

struct CompareOptions {
  std::string before;                 ///< a report.json
  std::string after;                  ///< another one, or the same
  std::vector<std::string> subjects;  ///< names, or OLD=NEW; if empty, all that are in both
  bool json = false;
};

/// Prints which properties fail now and did not before, fail worse or better, are fixed, or have no answer any more.
/// Returns 1 if anything is new, worse or unanswered, else 0. Throws InputError.
int compare_reports(const CompareOptions& options);

}  // namespace touchstone::app
