// The program's commands and options.
#pragma once

namespace touchstone::app {

/// Does what the command line says and returns the exit code. Wrong usage is told on stderr: 2. Throws InputError for
/// bad input.
int run_command(int argc, const char* const* argv);

}  // namespace touchstone::app
