// A finding as people read it, for the terminal and the page alike.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "oracle/finding.h"

namespace touchstone::app {

/// (label, words), in the order of reading; what a finding does not say is left out, and the proof too, which is the
/// truth's.
using Lines = std::vector<std::pair<std::string, std::string>>;

Lines lines_of(const oracle::Finding& finding);

/// "fails: missed", "holds".
std::string outcome_of(const oracle::Finding& finding);

}  // namespace touchstone::app
