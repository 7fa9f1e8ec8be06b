// The report for people: one page without scripts, which loads nothing.
#pragma once

#include <string>

#include "app/trial/ledger.h"

namespace touchstone::app {

std::string report_html(const Ledger& ledger);

}  // namespace touchstone::app
