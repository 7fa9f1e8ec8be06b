// A program on trial chooses its own name, and so not our files' places.
#pragma once

#include <string>
#include <vector>

#include "oracle/subject.h"

namespace touchstone::app {

/// What stands for each subject in the names of its files: letters, digits, '.', '-' and '_', at most 64. No two are
/// equal, nor are they where upper and lower case are the same; of two that would be, the later gets a number.
std::vector<std::string> names_of_files(const std::vector<oracle::Card>& cards);

}  // namespace touchstone::app
