#include "app/interruption.h"

#include <csignal>

namespace touchstone::app {
namespace {

volatile std::sig_atomic_t raised = 0;

void raise_flag(int signal) {
  raised = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void watch_for_interruption() {
  std::signal(SIGINT, raise_flag);
  std::signal(SIGTERM, raise_flag);
}

bool interrupted() { return raised != 0; }

}  // namespace touchstone::app
