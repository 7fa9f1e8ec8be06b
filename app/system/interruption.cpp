#include "app/system/interruption.h"

#include <csignal>
#include <initializer_list>

#include "oracle/process/living_children.h"

namespace touchstone::app {
namespace {

volatile std::sig_atomic_t watching = 0;
volatile std::sig_atomic_t raised = 0;

void raise_flag(int signal) {
  if (watching != 0 && raised == 0) {
    raised = signal;
    return;
  }
  oracle::kill_children();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

void take_children_along() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (std::signal(signal, raise_flag) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
}

void watch_for_interruption() { watching = 1; }

bool interrupted() { return raised != 0; }

int interrupted_exit_code() { return 128 + raised; }

}  // namespace touchstone::app
