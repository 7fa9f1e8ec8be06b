// The child processes that a signal which ends the program must end too: one that hangs would outlive it.
#pragma once

#include <sys/types.h>

namespace touchstone::oracle {

/// `leader` leads a process group of its own. Enter it once it runs; let it leave before it is reaped, while its number
/// cannot name another group.
void enter_child(pid_t leader);
void leave_child(pid_t leader);

/// Kills their groups. May be called by a signal handler.
void kill_children();

}  // namespace touchstone::oracle
