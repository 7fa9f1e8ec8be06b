// All output of the program goes through these functions: they make texts from outside printable, and notice when
// stdout accepts no more. Nothing else in app/ writes to the standard streams, except the progress bar.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <type_traits>

#include "model/printable.h"

namespace touchstone::app {

/// Call this first. It replaces a closed standard stream by one on which writing or reading fails too, so that no other
/// file gets its descriptor. Throws OutputError if stdout is closed.
void require_stdout();

/// Prints to stdout. Keeps line breaks; escapes everything else that is not printable.
void print_lines(std::string_view text);

/// Prints to stderr in the same way. Errors of writing are ignored, since there is no place left to report them.
void print_error_lines(std::string_view text);

/// The exit code of a command that would end with `code`. Flushes stdout. If stdout did not accept everything, the code
/// is nothing_reads_exit_code if its reader has gone (`| head`), else fault_exit_code with a message. An interrupted
/// run keeps its own exit code.
int exit_code_after_flush(int code);

inline constexpr int fault_exit_code = 3;            ///< a fault of Touchstone itself, or a full disk or closed stdout
inline constexpr int nothing_reads_exit_code = 141;  ///< 128 + SIGPIPE, as in shells

/// Makes a text printable, on one line; leaves numbers unchanged.
template <class T>
auto shown(const T& value) {
  if constexpr (std::is_arithmetic_v<T>) {
    return value;
  } else {
    static_assert(std::is_convertible_v<const T&, std::string_view>, "only numbers and texts are printed");
    return printable(value);
  }
}

/// The format is ours and may contain line breaks; each inserted text may come from outside.
template <class... Args>
std::string line_of(fmt::format_string<const Args&...> format, const Args&... args) {
  return fmt::format(fmt::runtime(format), shown(args)...);
}

/// Prints to stdout.
template <class... Args>
void print(fmt::format_string<const Args&...> format, const Args&... args) {
  print_lines(line_of<Args...>(format, args...));
}

/// Prints "touchstone: …" to stderr, on a line of its own.
template <class... Args>
void complain(fmt::format_string<const Args&...> format, const Args&... args) {
  print_error_lines("touchstone: " + line_of<Args...>(format, args...) + '\n');
}

}  // namespace touchstone::app
