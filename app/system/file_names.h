// File names for subjects. A subject chooses its own name, which must not decide where our files go.
#pragma once

#include <string>
#include <vector>

#include "oracle/subject.h"

namespace touchstone::app {

/// The name that stands for each subject in the names of its files: letters, digits, '.', '-' and '_', at most 64
/// characters. No two are equal, even if upper and lower case are the same; of two that would be equal, the later one
/// gets a number.
std::vector<std::string> names_of_files(const std::vector<oracle::Card>& cards);

}  // namespace touchstone::app
