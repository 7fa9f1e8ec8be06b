// A report.json, read again.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "oracle/judge/grade.h"

namespace touchstone::app {

/// What a report says of one subject under one property.
struct ReportedRow {
  std::string subject;
  std::string property;
  long holds = 0;
  long failures = 0;  ///< scenes on which it fails, breaks or refuses
  std::optional<oracle::Grade> grade;
  std::map<std::string, long> defects;  ///< how many scenes fail in each way
  std::string largest_error;            ///< with its unit; empty if errors have no size
  std::string case_file;                ///< beside the report; empty if there is none

  long answered() const { return holds + failures; }
};

struct ReportFile {
  std::string path;
  std::uint64_t seed = 0;
  std::string effort;
  int cases = 0;                                ///< drawn scenes per query
  std::map<std::string, std::string> versions;  ///< of each subject, by the name on its card
  std::vector<ReportedRow> rows;

  bool asks_the_scenes_of(const ReportFile& other) const {
    return seed == other.seed && effort == other.effort && cases == other.cases;
  }
};

/// A file that is missing, malformed, not a report, or of a run that was interrupted is an InputError that names the
/// place.
ReportFile read_report(const std::string& path);

}  // namespace touchstone::app
