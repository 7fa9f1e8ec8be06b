#include "app/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace touchstone::app {

Progress::Progress(std::string what, int steps)
    : what_(std::move(what)), steps_(steps), on_terminal_(isatty(STDERR_FILENO) == 1) {
  draw("");
}

Progress::~Progress() {
  if (on_terminal_) std::fputs("\r\033[K", stderr);
}

void Progress::step(const std::string& doing) {
  const std::lock_guard lock(mutex_);
  ++done_;
  draw(doing);
}

void Progress::draw(const std::string& doing) const {
  if (!on_terminal_ || steps_ == 0) return;
  constexpr int width = 30;
  const int filled = width * done_ / steps_;
  fmt::print(stderr, "\r\033[K{} [{:█<{}}{:·<{}}] {}/{} {}", what_, "", filled, "", width - filled, done_, steps_,
             doing);
  std::fflush(stderr);
}

}  // namespace touchstone::app
