// Which property detects which canary, on the scenes made by hand.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "oracle/subject.h"

namespace touchstone::tests {

/// The reference with remembered answers where they cost milliseconds; canaries change its answers.
std::unique_ptr<oracle::Subject> truthful();

/// For each property the canaries that it detects, which are those for which it fails or breaks on at least one scene;
/// and its verdict on the first such scene: the name of the defect, and the grade.
const std::map<std::string, std::map<std::string, std::string>>& kills();

/// The table in docs/spec/canaries.md.
std::string kill_table();

/// The clauses with their properties, as in docs/spec/clauses.md.
std::string clause_index();

}  // namespace touchstone::tests
