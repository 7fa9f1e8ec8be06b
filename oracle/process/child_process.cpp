#include "oracle/process/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/personality.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <system_error>
#include <thread>

#include "model/input_error.h"
#include "oracle/process/living_children.h"

extern char** environ;

namespace touchstone::oracle {
namespace {

using Clock = ChildProcess::Clock;

// All choices. What is kept of stderr has room for a sanitizer's report. What is quoted has room for a stack trace of
// some twenty calls with its reason, which JavaScript prints above the calls and Python below them. The times are long
// for a process that is alive and short for a person who waits.
constexpr std::size_t kept_of_stderr = 4096;
constexpr std::size_t quoted_of_stderr = 2000;
constexpr int tick_ms = 20;                   // between two checks of the clocks
constexpr double grace_when_dying = 1;        // s, for a child whose output has ended and that should exit soon
constexpr double grace_when_dismissed = 0.5;  // s, for a child that should exit at the end of its stdin

void require(bool done, const char* what) {
  if (!done) throw std::system_error(errno, std::generic_category(), what);
}

struct Ends {
  Descriptor parent;
  Descriptor child;
};

/// Each descriptor is made close-on-exec by the call that creates it, since another thread may start a child at any
/// moment.
Ends from_child() {
  int fds[2];
  require(pipe2(fds, O_CLOEXEC) == 0, "pipe");
  Ends ends{Descriptor(fds[0]), Descriptor(fds[1])};
  require(fcntl(fds[0], F_SETFL, O_NONBLOCK) == 0, "fcntl");
  return ends;
}

/// A socket, because send() can be prevented from raising SIGPIPE.
Ends to_child() {
  int fds[2];
  require(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, fds) == 0, "socketpair");
  return {Descriptor(fds[0]), Descriptor(fds[1])};
}

/// Programs that this thread starts while it lives have their memory at the same addresses each time. An engine that
/// sorts by address, or reads memory that it has freed, then answers the same in every run. Where the kernel refuses
/// (some containers), addresses stay random.
class FixedAddresses {
 public:
  FixedAddresses() : before_(personality(0xffffffff)) {  // this argument only asks
    if (before_ != -1) personality(static_cast<unsigned long>(before_) | ADDR_NO_RANDOMIZE);
  }
  ~FixedAddresses() {
    if (before_ != -1) personality(static_cast<unsigned long>(before_));
  }
  FixedAddresses(const FixedAddresses&) = delete;
  FixedAddresses& operator=(const FixedAddresses&) = delete;

 private:
  int before_;
};

/// posix_spawn instead of fork: it reports a program that cannot be run, and is safe in a process with many threads.
pid_t spawn(const std::vector<std::string>& command, int in, int out, int err) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigset_t all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);

  std::vector<char*> argv;
  for (const std::string& word : command) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  pid_t pid = -1;
  const FixedAddresses fixed_addresses;
  const int error = posix_spawnp(&pid, argv[0], &actions, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw InputError(command[0], fmt::format("cannot be run: {}", std::strerror(error)));
  return pid;
}

std::string text_of_status(int status) {
  if (WIFSIGNALED(status)) return fmt::format("signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  return fmt::format("exit status {}", WEXITSTATUS(status));
}

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& command) {
  Ends in = to_child();
  Ends out = from_child();
  Ends err = from_child();
  pid_ = spawn(command, in.child.get(), out.child.get(), err.child.get());
  enter_child(pid_);
  in_ = std::move(in.parent);
  out_ = std::move(out.parent);
  err_ = std::move(err.parent);
}

ChildProcess::~ChildProcess() { end(grace_when_dismissed); }

std::variant<std::string, Breaks> ChildProcess::exchange(const std::string& line, const Limits& limits) {
  if (pid_ < 0) return Breaks{Breaks::Kind::crashed, "it is not running"};
  Watch watch{Clock::now(), cpu_seconds()};
  std::size_t sent = 0;
  send_some(line, sent);
  while (true) {
    const bool open = wait_and_move(line, sent);
    if (std::optional<std::string> answer = take_line()) return *std::move(answer);
    if (!open) return Breaks{Breaks::Kind::crashed, end(grace_when_dying)};
    if (answers_.size() > limits.longest_line) {
      return killed(Breaks::Kind::garbage, fmt::format("an answer longer than {} bytes", limits.longest_line));
    }
    if (std::optional<Breaks> verdict = overdue(watch, limits)) return *std::move(verdict);
  }
}

/// Waits at most one tick. Returns false at the end of the child's output.
bool ChildProcess::wait_and_move(const std::string& line, std::size_t& sent) {
  std::array<pollfd, 3> waits = {
      {{out_.get(), POLLIN, 0}, {err_.get(), POLLIN, 0}, {sent < line.size() ? in_.get() : -1, POLLOUT, 0}}};
  poll(waits.data(), waits.size(), tick_ms);
  if (waits[1].revents && !read_stderr()) err_.close();
  if (waits[2].revents) send_some(line, sent);
  return !waits[0].revents || read_answers();
}

std::optional<std::string> ChildProcess::take_line() {
  const std::size_t end_of_line = answers_.find('\n', searched_);
  if (end_of_line == std::string::npos) {
    searched_ = answers_.size();
    return std::nullopt;
  }
  std::string line = answers_.substr(0, end_of_line);
  answers_.erase(0, end_of_line + 1);
  searched_ = 0;
  return line;
}

std::optional<Breaks> ChildProcess::overdue(Watch& watch, const Limits& limits) {
  const double elapsed = seconds_since(watch.start);
  if (elapsed < watch.next_check) return std::nullopt;
  watch.next_check = elapsed + tick_ms / 1000.0;
  // The child's own children may hold its output open. All that the child wrote has been read by the second check.
  if (watch.ended) return Breaks{Breaks::Kind::crashed, end(grace_when_dying)};
  watch.ended = ends_within(0);
  if (cpu_seconds() - watch.cpu_start > limits.cpu_seconds) {
    return killed(Breaks::Kind::hung, fmt::format("no answer within {} s of its own CPU time", limits.cpu_seconds));
  }
  if (limits.given_up != nullptr && limits.given_up()) return killed(Breaks::Kind::hung, "the run was interrupted");
  if (elapsed > limits.wall_seconds) {
    return killed(Breaks::Kind::hung, fmt::format("no answer within {} s", limits.wall_seconds));
  }
  return std::nullopt;
}

void ChildProcess::say(const std::string& line) {
  std::size_t sent = 0;
  send_some(line, sent);
}

Breaks ChildProcess::killed(Breaks::Kind kind, const std::string& why) {
  ::kill(-pid_, SIGKILL);
  end(grace_when_dying);
  return {kind, why};
}

std::string ChildProcess::end(double grace_seconds) {
  if (pid_ < 0) return "it is not running";
  in_.close();
  out_.close();
  const bool by_itself = ends_within(grace_seconds);
  // The child has not been reaped yet, so the number still names this process group and no other.
  ::kill(-pid_, SIGKILL);
  leave_child(pid_);
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  for (int reads = 0; reads < 16 && read_stderr(); ++reads) {
  }
  const std::string halfway = answers_.empty() ? "" : ", in the middle of an answer";
  return (by_itself ? text_of_status(status) : "it closed its output and went on") + halfway + last_words();
}

/// Ignores errors: if the child no longer reads, the end of its output will show it.
void ChildProcess::send_some(const std::string& line, std::size_t& sent) {
  const ssize_t count = send(in_.get(), line.data() + sent, line.size() - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
  if (count >= 0) {
    sent += static_cast<std::size_t>(count);
  } else if (errno != EAGAIN && errno != EINTR) {
    sent = line.size();
  }
}

/// Returns false at the end of the child's output.
bool ChildProcess::read_answers() {
  std::array<char, 65536> bytes;
  const ssize_t count = read(out_.get(), bytes.data(), bytes.size());
  if (count > 0) answers_.append(bytes.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && (errno == EAGAIN || errno == EINTR));
}

/// Returns false at the end of the child's stderr, or if there is nothing to read now.
bool ChildProcess::read_stderr() {
  std::array<char, 65536> bytes;
  const ssize_t count = read(err_.get(), bytes.data(), bytes.size());
  if (count <= 0) return false;
  stderr_tail_.append(bytes.data(), static_cast<std::size_t>(count));
  if (stderr_tail_.size() > kept_of_stderr) stderr_tail_.erase(0, stderr_tail_.size() - kept_of_stderr);
  return true;
}

double ChildProcess::cpu_seconds() const {
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(pid_, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

bool ChildProcess::ends_within(double seconds) const {
  const Clock::time_point start = Clock::now();
  while (true) {
    siginfo_t info{};
    if (waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == pid_)
      return true;
    if (seconds_since(start) > seconds) return false;
    std::this_thread::sleep_for(std::chrono::microseconds(500));
  }
}

std::string ChildProcess::last_words() const {
  std::string words = stderr_tail_.substr(stderr_tail_.size() - std::min(stderr_tail_.size(), quoted_of_stderr));
  for (char& c : words) {
    if (c == '\n' || c == '\t') c = ' ';
    if (c < ' ' || c > '~') c = '?';
  }
  const std::size_t first = words.find_first_not_of(' ');
  if (first == std::string::npos) return "";
  return ": " + words.substr(first, words.find_last_not_of(' ') - first + 1);
}

}  // namespace touchstone::oracle
