// The report for people: one page, no script, nothing fetched.
#pragma once

#include <string>

#include "app/ledger.h"

namespace touchstone::app {

std::string report_html(const Ledger& ledger);

}  // namespace touchstone::app
