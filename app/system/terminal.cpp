#include "app/system/terminal.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <initializer_list>

#include "model/output_error.h"

namespace touchstone::app {
namespace {

int failure = 0;  // errno of the first failed write to stdout

void note_failure() {
  if (failure == 0) failure = errno != 0 ? errno : EIO;
}

void flush() {
  errno = 0;
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) note_failure();
}

bool is_closed(int descriptor) { return fcntl(descriptor, F_GETFD) < 0 && errno == EBADF; }

/// open() takes the lowest free number. Reading from stdin and writing to the others still fails with EBADF.
void stand_in_for(int descriptor) {
  static_cast<void>(open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY));
}

void do_nothing(int) {}

}  // namespace

void require_stdout() {
  // A handler, since ignored signals stay ignored in child processes: a write then fails with EPIPE or EFBIG.
  std::signal(SIGPIPE, do_nothing);
  std::signal(SIGXFSZ, do_nothing);
  const bool closed = is_closed(STDOUT_FILENO);
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (is_closed(descriptor)) stand_in_for(descriptor);
  }
  if (closed) throw OutputError("stdout", "is closed: there is no place for the answer");
}

void print_lines(std::string_view text) {
  if (failure != 0) return;
  const std::string safe = printable_lines(text);
  errno = 0;
  if (std::fwrite(safe.data(), 1, safe.size(), stdout) != safe.size()) note_failure();
}

void print_error_lines(std::string_view text) {
  const std::string safe = printable_lines(text);
  flush();
  std::fwrite(safe.data(), 1, safe.size(), stderr);
}

int exit_code_after_flush(int code) {
  flush();
  if (failure == 0) return code;
  constexpr int signals = 128;
  if (failure == EPIPE) return code > signals ? code : nothing_reads_exit_code;
  complain("stdout: cannot write: {}", std::strerror(failure));
  return code > signals ? code : fault_exit_code;
}

}  // namespace touchstone::app
