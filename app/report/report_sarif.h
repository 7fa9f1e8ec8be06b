// The report as SARIF 2.1.0, for code scanning: a rule for each property, a result for each failing row.
#pragma once

#include <string>

#include "app/trial/ledger.h"
#include "model/json.h"

namespace touchstone::app {

/// `folder` is the report's, to which the rows' case files are relative; empty: no case was written, so that no result
/// has a file. A file below the working folder is named relative to it, as code scanning wants it.
Json report_sarif(const Ledger& ledger, const std::string& folder);

}  // namespace touchstone::app
