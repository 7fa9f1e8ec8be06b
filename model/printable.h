// Text from outside (names, keys, words on the command line, what an engine says) on its way to a terminal or a log.
#pragma once

#include <string>
#include <string_view>

namespace touchstone {

/// One line without surprises. Control characters, line breaks, invisible characters and those that change the
/// direction of writing become the escapes of JSON (\n, \u001b, \u202e); a byte that is not UTF-8 becomes \xff. All
/// else stays, so that printable(printable(text)) == printable(text).
std::string printable(std::string_view text);

/// The same, but line breaks stay: for text that is laid out in lines. JSON remains the same JSON.
std::string printable_lines(std::string_view text);

}  // namespace touchstone
