// Makes text from outside (names, keys, words of the command line, messages of engines) safe for a terminal or a log.
#pragma once

#include <string>
#include <string_view>

namespace touchstone {

/// Returns one line of printable text. Control characters, line breaks, invisible characters and those that change the
/// writing direction become JSON escapes (`\n`, `\u001b`, `\u202e`); a byte that is not UTF-8 becomes `\xff`.
/// Everything else is unchanged, so printable(printable(text)) == printable(text).
std::string printable(std::string_view text);

/// The same, but keeps line breaks: for text that is laid out in lines. JSON remains the same JSON.
std::string printable_lines(std::string_view text);

}  // namespace touchstone
