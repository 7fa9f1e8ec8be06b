// Shell completion, made from the description of the commands and options that the program parses itself by.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

namespace touchstone::app {

/// The words that a value may be, by the name that the help has for it: {"EFFORT", {"quick", ...}}.
using ValueWords = std::map<std::string, std::vector<std::string>>;

/// The shells that there is a script for.
const std::vector<std::string>& completion_shells();

std::string completion_script(const CLI::App& program, const ValueWords& words, const std::string& shell);

}  // namespace touchstone::app
