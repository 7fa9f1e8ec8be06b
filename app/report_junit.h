// The report as JUnit XML: a suite a subject, a test case a property. Abstaining is "skipped", never "passed".
#pragma once

#include <string>

#include "app/ledger.h"

namespace touchstone::app {

std::string report_junit(const Ledger& ledger);

}  // namespace touchstone::app
