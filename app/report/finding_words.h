// A finding in words, for the terminal and the page.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "oracle/finding.h"

namespace touchstone::app {

/// Pairs (label, words), in reading order. Parts that the finding does not have are left out; so is the proof, which
/// belongs to the truth.
using Lines = std::vector<std::pair<std::string, std::string>>;

Lines lines_of(const oracle::Finding& finding);

/// "fails: missed", "holds".
std::string outcome_of(const oracle::Finding& finding);

}  // namespace touchstone::app
