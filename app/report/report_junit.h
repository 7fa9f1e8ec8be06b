// The report as JUnit XML: one suite per subject, one test case per property. Abstaining is "skipped", never "passed".
#pragma once

#include <string>

#include "app/trial/ledger.h"

namespace touchstone::app {

std::string report_junit(const Ledger& ledger);

}  // namespace touchstone::app
