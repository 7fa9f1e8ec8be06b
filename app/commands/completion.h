// Shell completion, generated from the description of commands and options with which the program parses them.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

namespace touchstone::app {

/// The words that a value may be, by the value's name in the help: {"EFFORT", {"quick", ...}}.
using ValueWords = std::map<std::string, std::vector<std::string>>;

/// The shells for which there is a script.
const std::vector<std::string>& completion_shells();

std::string completion_script(const CLI::App& program, const ValueWords& words, const std::string& shell);

}  // namespace touchstone::app
