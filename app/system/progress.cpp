#include "app/system/progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "model/printable.h"

namespace touchstone::app {
namespace {

constexpr int longest_bar = 30;
constexpr int shortest_bar = 5;
constexpr int usual_columns = 80;  // if the terminal does not say

int columns_of_terminal() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : usual_columns;
}

bool begins_character(char byte) { return (static_cast<unsigned char>(byte) & 0xc0) != 0x80; }

/// Counts two columns for characters that may be wide (beyond Latin, Greek and Cyrillic), except for the bar's own. It
/// is better to count too many than to have the line wrap.
int columns_of(char lead) {
  const auto byte = static_cast<unsigned char>(lead);
  return !begins_character(lead) ? 0 : byte < 0xe1 ? 1 : 2;
}

/// The longest beginning of the text that fits; the text is valid UTF-8.
std::string cut(std::string_view text, int columns) {
  std::size_t end = 0;
  for (int used = 0; end < text.size(); ++end) {
    used += columns_of(text[end]);
    if (used > columns) break;
  }
  return std::string(text.substr(0, end));
}

std::string times(int done, int steps, double seconds) {
  if (done == 0) return clock_time(seconds);
  return fmt::format("{}, {} left", clock_time(seconds), clock_time(seconds / done * (steps - done)));
}

}  // namespace

bool draws_bars() {
  const char* terminal = std::getenv("TERM");
  return isatty(STDERR_FILENO) == 1 && (terminal == nullptr || std::string_view(terminal) != "dumb");
}

std::string clock_time(double seconds) {
  const auto all = static_cast<long>(std::clamp(seconds, 0.0, 3.6e9));
  const long hours = all / 3600, minutes = all / 60 % 60;
  return hours > 0 ? fmt::format("{}:{:02}:{:02}", hours, minutes, all % 60)
                   : fmt::format("{}:{:02}", minutes, all % 60);
}

std::string bar_line(std::string_view what, int done, int steps, double seconds, std::string_view doing, int columns) {
  const std::string first = printable(what);
  const std::string last = fmt::format("{}/{} {}", done, steps, times(done, steps, seconds));
  const auto plain = static_cast<int>(first.size() + last.size());
  const int bar = std::min(columns - plain - 4, longest_bar);  // two spaces and two brackets
  if (bar < shortest_bar) return cut(plain < columns ? first + ' ' + last : last, columns);
  const int filled = bar * std::min(done, steps) / std::max(1, steps);
  const std::string line = fmt::format("{} [{:█<{}}{:·<{}}] {}", first, "", filled, "", bar - filled, last);
  const int left = columns - plain - 4 - bar - 2;
  return doing.empty() || left < 1 ? line : line + "  " + cut(printable(doing), left);
}

Progress::Progress(std::string what, int steps)
    : what_(std::move(what)), steps_(steps), on_terminal_(steps > 0 && draws_bars()) {
  if (on_terminal_) clock_ = std::thread([this] { redraw_until_stopped(); });
}

Progress::~Progress() {
  if (!on_terminal_) return;
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
  }
  stop_.notify_one();
  clock_.join();
  std::fputs("\r\033[K", stderr);
}

void Progress::step(const std::string& doing, int steps) {
  const std::lock_guard lock(mutex_);
  done_ += steps;
  doing_ = doing;
  draw();
}

void Progress::redraw_until_stopped() {
  std::unique_lock lock(mutex_);
  do draw();
  while (!stop_.wait_for(lock, std::chrono::seconds(1), [this] { return stopped_; }));
}

/// Leaves the last column free: some terminals wrap as soon as it is written to.
void Progress::draw() const {
  if (!on_terminal_) return;
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  fmt::memory_buffer line;
  fmt::format_to(std::back_inserter(line), "\r\033[K{}",
                 bar_line(what_, done_, steps_, seconds, doing_, columns_of_terminal() - 1));
  std::fwrite(line.data(), 1, line.size(), stderr);
  std::fflush(stderr);
}

}  // namespace touchstone::app
