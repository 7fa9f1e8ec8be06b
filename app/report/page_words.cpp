#include <fmt/format.h>

#include <algorithm>

#include "app/report/page.h"
#include "app/report/xml.h"

namespace touchstone::app::page {
namespace {

constexpr std::size_t longest_text = 600;

}  // namespace

/// Cuts between characters, not inside one.
std::string shown(const std::string& text) {
  std::size_t end = std::min(text.size(), longest_text);
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return escaped(end == text.size() ? text : text.substr(0, end) + " …");
}

std::string badge(oracle::Grade grade) {
  return fmt::format("<span class=\"g {0}\">{0}</span>", oracle::name_of(grade));
}

std::string anchor(const Row& row) { return escaped(row.property->id + "." + row.subject->card.name); }

std::string definition(const std::string& term, const std::string& html) {
  return html.empty() ? "" : fmt::format("<dt>{}</dt><dd>{}</dd>", term, html);
}

std::string plural(long count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace touchstone::app::page
