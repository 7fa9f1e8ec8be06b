#include <fmt/format.h>

#include <algorithm>

#include "app/report/page/page.h"
#include "app/report/xml.h"

namespace touchstone::app::page {
namespace {

constexpr std::size_t longest_text = 600;
constexpr std::size_t longest_end = 250;  ///< of a text that is longer

/// The begin of the character at an offset.
std::size_t between_characters(const std::string& text, std::size_t at) {
  while (at < text.size() && at > 0 && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80) --at;
  return at;
}

}  // namespace

/// Leaves out the middle: a stack trace has its reason in the first line or in the last one.
std::string shown(const std::string& text) {
  if (text.size() <= longest_text) return escaped(text);
  const std::size_t first = between_characters(text, longest_text - longest_end);
  const std::size_t last = between_characters(text, text.size() - longest_end);
  return escaped(text.substr(0, first) + " … " + text.substr(last));
}

std::string badge(oracle::Grade grade) {
  return fmt::format("<span class=\"g {0}\">{0}</span>", oracle::name_of(grade));
}

std::string anchor(const Row& row) {
  const bool beyond = row.examples.smallest && !row.examples.smallest->beyond.empty();
  return escaped(row.property->id + "." + row.subject->card.name + (beyond ? ".beyond" : ""));
}

std::string subject_anchor(const TestedSubject& subject) { return escaped("subject." + subject.card.name); }

std::string failures_anchor(const TestedSubject& subject) { return escaped("failures." + subject.card.name); }

std::string table_anchor(const std::string& query) { return "table." + query; }

std::string silence_of(const Counts& counts) {
  if (counts.abstains > 0) return "abstains";
  if (counts.beyond > 0) return "beyond its domain";
  if (counts.unanswered > 0) return "no answer";
  return counts.not_asked > 0 ? "not asked" : "outside";
}

std::string breakable(const std::string& name) {
  std::string html;
  for (const char c : escaped(name)) html += c == '_' ? "_<wbr>" : std::string(1, c);
  return html;
}

std::string scrolling(const std::string& label, const std::string& html) {
  return fmt::format("<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{}\">{}</div>", escaped(label),
                     html);
}

std::string definition(const std::string& term, const std::string& html) {
  return html.empty() ? "" : fmt::format("<dt>{}</dt><dd>{}</dd>", term, html);
}

std::string plural(long count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace touchstone::app::page
