// Ctrl-C, a termination or a closed terminal ask for an orderly end: the run stops asking, and writes what it knows.
#pragma once

namespace touchstone::app {

/// From now on SIGINT, SIGTERM and SIGHUP end the child processes too when they end the program. A signal that is
/// ignored already (nohup) stays so.
void take_children_along();

/// From now on the first of these signals only raises a flag; a second one ends the program at once.
void watch_for_interruption();

bool interrupted();

/// Of a run that was interrupted, after its partial report: 128 + the signal, as shells count. SIGHUP 129, SIGINT 130,
/// SIGTERM 143.
int interrupted_exit_code();

}  // namespace touchstone::app
