// The command summary: a report as a table in Markdown, for a README, an issue or the page of a CI job.
#pragma once

#include <string>
#include <vector>

#include "app/trend/report_file.h"

namespace touchstone::app {

/// Subjects × queries: how many properties hold of those that are answered, the share of wrong answers, and the worst
/// grade. Only `subjects`, in this order; if empty, all that answer anything. Ends with the command that asks the same
/// scenes. Throws InputError for a subject that is not in the report.
std::string summary_of(const ReportFile& report, const std::vector<std::string>& subjects);

/// Prints the summary of a report.json. Throws InputError.
void summarise(const std::string& path, const std::vector<std::string>& subjects);

}  // namespace touchstone::app
