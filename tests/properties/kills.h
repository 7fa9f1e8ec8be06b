// Which property catches which canary, on the scenes by hand.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>

#include "oracle/subject.h"

namespace touchstone::tests {

/// The reference, asked once where its answers cost milliseconds: canaries lie on top of it.
std::unique_ptr<oracle::Subject> truthful();

/// Property → canaries that it catches: at least one scene on which it fails or breaks.
const std::map<std::string, std::set<std::string>>& kills();

/// The table, as docs/spec/canaries.md has it.
std::string kill_table();

/// The clauses with their properties, as docs/spec/clauses.md has them.
std::string clause_index();

}  // namespace touchstone::tests
