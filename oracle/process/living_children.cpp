#include "oracle/process/living_children.h"

#include <signal.h>

#include <array>
#include <atomic>

namespace touchstone::oracle {
namespace {

/// Of fixed size and lock-free, because a signal handler reads it. A child that finds no free entry is not killed.
std::array<std::atomic<pid_t>, 1 << 16> children;
static_assert(std::atomic<pid_t>::is_always_lock_free);

void replace_first(pid_t old, pid_t by) {
  for (std::atomic<pid_t>& child : children) {
    pid_t expected = old;
    if (child.compare_exchange_strong(expected, by)) return;
  }
}

}  // namespace

void enter_child(pid_t leader) { replace_first(0, leader); }

void leave_child(pid_t leader) { replace_first(leader, 0); }

void kill_children() {
  for (const std::atomic<pid_t>& child : children) {
    if (const pid_t leader = child; leader > 0) ::kill(-leader, SIGKILL);
  }
}

}  // namespace touchstone::oracle
