// A child process that answers each line with one line, and is not trusted in any way.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/answers.h"
#include "oracle/process/descriptor.h"

namespace touchstone::oracle {

/// Its stdin and stdout carry the lines. Its stderr is read, and only the last few kilobytes are kept. The child leads
/// a process group of its own, which is killed together with it. Its memory is at the same addresses in every run,
/// where the kernel permits it.
class ChildProcess {
 public:
  using Clock = std::chrono::steady_clock;

  struct Limits {
    double cpu_seconds;            ///< CPU time of the child itself, all threads
    double wall_seconds;           ///< a second limit, for a child that sleeps
    std::size_t longest_line;      ///< bytes
    bool (*given_up)() = nullptr;  ///< polled; true: the answer is no longer needed
  };

  /// Program and arguments, at least one word. Throws InputError if the program cannot be run.
  explicit ChildProcess(const std::vector<std::string>& command);
  ~ChildProcess();  ///< ends the child, after a short grace period
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Sends a line (ends with \n) and returns the answer without its \n. After a Breaks the child is dead.
  std::variant<std::string, Breaks> exchange(const std::string& line, const Limits& limits);

  /// Sends a line that has no answer. Drops it if the pipe has no room.
  void say(const std::string& line);

  /// Closes the child's stdin, waits for the grace period, then kills it. Returns how it ended: "signal 6 (Aborted):
  /// <end of its stderr>".
  std::string end(double grace_seconds);

  /// The child's own CPU time until now, all threads, s.
  double cpu_seconds() const;

 private:
  struct Watch {
    Clock::time_point start;
    double cpu_start;
    double next_check = 0;
    bool ended = false;
  };

  bool wait_and_move(const std::string& line, std::size_t& sent);
  std::optional<std::string> take_line();
  std::optional<Breaks> overdue(Watch& watch, const Limits& limits);
  Breaks killed(Breaks::Kind kind, const std::string& why);
  void send_some(const std::string& line, std::size_t& sent);
  bool read_answers();
  bool read_stderr();
  bool ends_within(double seconds) const;
  std::string last_words() const;

  pid_t pid_ = -1;
  Descriptor in_;
  Descriptor out_;
  Descriptor err_;
  std::string answers_;       ///< read, not yet returned
  std::size_t searched_ = 0;  ///< bytes of answers_ that hold no end of line
  std::string stderr_tail_;   ///< the end of what it printed on stderr
};

}  // namespace touchstone::oracle
