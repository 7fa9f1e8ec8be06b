// All that the program prints goes through here: texts from outside are made printable, and a stdout that takes no more
// is noticed. Nothing else in app/ writes to the standard streams but the progress bar.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <type_traits>

#include "model/printable.h"

namespace touchstone::app {

/// At the very start: a standard stream that is closed is replaced by one that fails likewise, so that no file of ours
/// gets its descriptor. Throws OutputError if stdout is closed.
void require_stdout();

/// To stdout. Line breaks stay; all else that is not printable is escaped.
void print_lines(std::string_view text);

/// To stderr, likewise. What cannot be written is lost: there is no place left to say so.
void print_error_lines(std::string_view text);

/// The exit code of a command that would end with `code`. Flushes stdout. If it did not take all that was printed:
/// nothing_reads_exit_code where its reader has gone (`| head`), else 3 with a message. A run that was interrupted
/// keeps its own exit code.
int exit_code_after_flush(int code);

inline constexpr int output_error_exit_code = 3;
inline constexpr int nothing_reads_exit_code = 141;  ///< 128 + SIGPIPE, as shells count

/// A text becomes printable, on one line; numbers stay.
template <class T>
auto shown(const T& value) {
  if constexpr (std::is_arithmetic_v<T>) {
    return value;
  } else {
    static_assert(std::is_convertible_v<const T&, std::string_view>, "only numbers and texts are printed");
    return printable(value);
  }
}

/// The format is ours and may hold line breaks; each text that is put into it may come from outside.
template <class... Args>
std::string line_of(fmt::format_string<const Args&...> format, const Args&... args) {
  return fmt::format(fmt::runtime(format), shown(args)...);
}

/// To stdout.
template <class... Args>
void print(fmt::format_string<const Args&...> format, const Args&... args) {
  print_lines(line_of<Args...>(format, args...));
}

/// To stderr: "touchstone: …", a line of its own.
template <class... Args>
void complain(fmt::format_string<const Args&...> format, const Args&... args) {
  print_error_lines("touchstone: " + line_of<Args...>(format, args...) + '\n');
}

}  // namespace touchstone::app
