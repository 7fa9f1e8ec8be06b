// The exact answers of the reference, printed for a query and a scene.
#pragma once

#include <string>
#include <vector>

namespace touchstone::app {

/// The names of the queries whose answers `ask` can print.
const std::vector<std::string>& printed_queries();

/// Reads the scene (app/motion/given_scene.h), queries the reference, prints words or JSON to stdout. Throws
/// InputError.
void ask(const std::string& query, const std::string& name_or_file, bool as_json);

}  // namespace touchstone::app
