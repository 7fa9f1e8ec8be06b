// The report for programs. It contains no times, so the same run gives the same bytes.
#pragma once

#include "app/trial/ledger.h"
#include "model/json.h"

namespace touchstone::app {

Json report_json(const Ledger& ledger);

/// Writes JSON as text. Invalid bytes in an engine's messages are replaced.
std::string text_of(const Json& json);

}  // namespace touchstone::app
