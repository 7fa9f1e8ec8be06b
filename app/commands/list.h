// Lists the subjects, properties, clauses, families, canaries and scenes in motion.
#pragma once

#include <string>
#include <vector>

namespace touchstone::app {

/// "subjects", "properties", "clauses", "families", "canaries", "motions".
const std::vector<std::string>& listable();

void list(const std::string& what);

}  // namespace touchstone::app
