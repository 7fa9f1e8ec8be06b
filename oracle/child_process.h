// A child process that is asked one line and answers one line, and can be trusted in nothing.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/answers.h"
#include "oracle/descriptor.h"

namespace touchstone::oracle {

/// Its stdin and stdout carry the lines; what it prints on stderr is read and dropped but for the last few kilobytes.
/// It leads a process group of its own, which is killed with it.
class ChildProcess {
 public:
  using Clock = std::chrono::steady_clock;

  struct Limits {
    double cpu_seconds;            ///< of the child itself, all threads
    double wall_seconds;           ///< the backstop, for one that sleeps
    std::size_t longest_line;      ///< bytes
    bool (*given_up)() = nullptr;  ///< asked again and again: does nobody wait for the answer any more?
  };

  /// Program and arguments, at least one word. Throws InputError if the program cannot be run.
  explicit ChildProcess(const std::vector<std::string>& command);
  ~ChildProcess();  ///< ends it, after a short grace
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Sends a line (ends with \n); returns the answer without its \n. After a Breaks the child is dead.
  std::variant<std::string, Breaks> exchange(const std::string& line, const Limits& limits);

  /// Sends a line that has no answer, if there is room for it.
  void say(const std::string& line);

  /// Ends its stdin, waits that long, then kills it; says how it ended: "signal 6 (Aborted): <its last words>".
  std::string end(double grace_seconds);

 private:
  struct Watch {
    Clock::time_point start;
    double cpu_start;
    double next_look = 0;
    bool ended = false;
  };

  bool wait_and_move(const std::string& line, std::size_t& sent);
  std::optional<std::string> take_line();
  std::optional<Breaks> overdue(Watch& watch, const Limits& limits);
  Breaks killed(Breaks::Kind kind, const std::string& why);
  void send_some(const std::string& line, std::size_t& sent);
  bool read_answers();
  bool read_stderr();
  double cpu_seconds() const;
  bool ends_within(double seconds) const;
  std::string last_words() const;

  pid_t pid_ = -1;
  Descriptor in_;
  Descriptor out_;
  Descriptor err_;
  std::string answers_;       ///< read, not yet returned
  std::size_t searched_ = 0;  ///< of answers_, for the end of a line
  std::string stderr_tail_;   ///< what it printed last
};

}  // namespace touchstone::oracle
