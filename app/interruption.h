// Ctrl-C asks for an orderly end: the run stops asking, and writes what it knows.
#pragma once

namespace touchstone::app {

/// From now on SIGINT and SIGTERM only raise a flag; a second one ends the program at once.
void watch_for_interruption();

bool interrupted();

/// Exit code of a run that was interrupted, after its partial report: 128 + SIGINT, as shells count.
inline constexpr int interrupted_exit_code = 130;

}  // namespace touchstone::app
