// The report for machines. The same run gives the same bytes; times are not in it.
#pragma once

#include "app/ledger.h"
#include "model/json.h"

namespace touchstone::app {

Json report_json(const Ledger& ledger);

/// As text that any bytes of an engine's messages cannot spoil.
std::string text_of(const Json& json);

}  // namespace touchstone::app
