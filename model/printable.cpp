#include "model/printable.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>

namespace touchstone {
namespace {

struct Character {
  char32_t code = 0;
  std::size_t bytes = 0;  ///< 0 if it is not UTF-8
};

/// Strict: accepts neither overlong forms nor surrogates.
Character first_of(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead < 0xc0 ? 0 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : lead < 0xf8 ? 4 : 0;
  if (bytes == 0 || text.size() < bytes) return {};
  char32_t code = lead & (0xffU >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {};
    code = (code << 6) | (byte(i) & 0x3fU);
  }
  constexpr std::array<char32_t, 5> least = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = 0xd800 <= code && code <= 0xdfff;
  if (code < least[bytes] || surrogate || code > 0x10ffff) return {};
  return {code, bytes};
}

struct Range {
  char32_t first, last;
};

/// Characters that move the cursor, break the line, change the writing direction, or are invisible.
constexpr std::array<Range, 10> harmful_ranges = {{
    {0x00, 0x1f},
    {0x7f, 0x9f},
    {0x61c, 0x61c},      // Arabic letter mark
    {0x200b, 0x200f},    // zero width; writing direction
    {0x2028, 0x202e},    // line breaks; writing direction
    {0x2060, 0x206f},    // invisible; writing direction
    {0xfeff, 0xfeff},    // byte order mark
    {0xfff9, 0xfffc},    // annotations; objects
    {0xfffe, 0xffff},    // noncharacters, which XML forbids
    {0xe0000, 0xe0fff},  // tags
}};

bool harmful(char32_t code) {
  return std::ranges::any_of(harmful_ranges, [code](Range range) { return range.first <= code && code <= range.last; });
}

std::string formatted(const char* format, unsigned value) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string escape(char32_t code) {
  if (code == '\n') return "\\n";
  if (code == '\r') return "\\r";
  if (code == '\t') return "\\t";
  if (code < 0x10000) return formatted("\\u%04x", code);
  const auto beyond = static_cast<std::uint32_t>(code) - 0x10000;
  return formatted("\\u%04x", 0xd800 + (beyond >> 10)) + formatted("\\u%04x", 0xdc00 + (beyond & 0x3ff));
}

std::string shown(std::string_view text, bool keeps_lines) {
  std::string result;
  result.reserve(text.size());
  while (!text.empty()) {
    const Character next = first_of(text);
    if (next.bytes == 0) {
      result += formatted("\\x%02x", static_cast<unsigned char>(text[0]));
    } else if (harmful(next.code) && !(keeps_lines && next.code == '\n')) {
      result += escape(next.code);
    } else {
      result += text.substr(0, next.bytes);
    }
    text.remove_prefix(std::max<std::size_t>(1, next.bytes));
  }
  return result;
}

}  // namespace

std::string printable(std::string_view text) { return shown(text, false); }

std::string printable_lines(std::string_view text) { return shown(text, true); }

}  // namespace touchstone
