// The child processes that must be killed when a signal ends the program. A hanging child would otherwise outlive it.
#pragma once

#include <sys/types.h>

namespace touchstone::oracle {

/// `leader` leads a process group of its own. Enter it once it runs, and remove it before it is reaped, while its
/// number cannot name another group.
void enter_child(pid_t leader);
void leave_child(pid_t leader);

/// Kills their process groups. A signal handler may call it.
void kill_children();

}  // namespace touchstone::oracle
