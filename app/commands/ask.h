// The exact answers of the reference, printed for a query and a scene.
#pragma once

#include <string>
#include <vector>

#include "model/json.h"
#include "model/scene.h"

namespace touchstone::app {

/// The names of the queries whose answers `ask` can print.
const std::vector<std::string>& printed_queries();

/// The exact answer that `ask --json` prints. The query is one of printed_queries(), and the scene is completed
/// (reference/validity.h). Throws InputError.
Json exact_answer(const std::string& query, const Scene& scene);

/// Prints an exact answer in words, each line after `indent`.
void print_answer(const Json& answer, const std::string& indent);

/// Reads the scene (app/motion/given_scene.h), queries the reference, prints words or JSON to stdout. Throws
/// InputError.
void ask(const std::string& query, const std::string& name_or_file, bool as_json);

}  // namespace touchstone::app
