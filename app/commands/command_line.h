// The program's commands and options.
#pragma once

namespace touchstone::app {

/// Executes the command line and returns the exit code. Wrong usage is reported on stderr, with exit code 2. Throws
/// InputError for bad input.
int run_command(int argc, const char* const* argv);

}  // namespace touchstone::app
