// Ctrl-C, SIGTERM or a closed terminal end a run in an orderly way: it asks no more queries, and writes its results.
#pragma once

namespace touchstone::app {

/// From now on SIGINT, SIGTERM and SIGHUP, when they end the program, end the child processes too. A signal that is
/// already ignored (nohup) stays ignored.
void take_children_along();

/// From now on the first of these signals only sets a flag; a second one ends the program at once.
void watch_for_interruption();

bool interrupted();

/// The exit code of an interrupted run, after its partial report: 128 + the signal, as in shells. SIGHUP 129, SIGINT
/// 130, SIGTERM 143.
int interrupted_exit_code();

}  // namespace touchstone::app
