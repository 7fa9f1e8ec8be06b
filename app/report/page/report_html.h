// The report for people: one page that loads nothing, and shows everything without its script.
#pragma once

#include <string>

#include "app/trial/ledger.h"

namespace touchstone::app {

std::string report_html(const Ledger& ledger);

}  // namespace touchstone::app
