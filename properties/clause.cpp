#include "properties/clause.h"

#include <algorithm>
#include <array>
#include <map>

#include "model/input_error.h"
#include "oracle/query.h"
#include "properties/spec_pages.h"

namespace touchstone::properties {
namespace {

constexpr std::string_view heading = "### ";
constexpr std::string_view id_end = " · ";
constexpr std::string_view strong = "**";
constexpr std::array<std::string_view, 7> keys = {"Domain", "Truth",      "Allowed",        "Freedom",
                                                  "Source", "Checked by", "Proved sharp by"};

// The words on one line, without list markers and outer blanks.
std::string flat(std::string_view text) {
  std::string words;
  bool gap = false;
  for (const char c : text) {
    if (c == ' ' || c == '\n') {
      gap = !words.empty();
    } else {
      if (gap) words += ' ';
      gap = false;
      words += c;
    }
  }
  while (words.ends_with(" -")) words.erase(words.size() - 2);
  return words == "-" ? "" : words;
}

// The strings between backquotes.
std::vector<std::string> names(const std::string& text) {
  std::vector<std::string> found;
  for (std::size_t open = text.find('`'); open != std::string::npos;) {
    const std::size_t close = text.find('`', open + 1);
    if (close == std::string::npos) break;
    found.push_back(text.substr(open + 1, close - open - 1));
    open = text.find('`', close + 1);
  }
  return found;
}

std::map<std::string, std::string, std::less<>> keyed(std::string_view text, const std::string& place) {
  std::map<std::string, std::string, std::less<>> values;
  while (!text.empty()) {
    const std::size_t close = text.find(strong, strong.size());
    if (close == std::string_view::npos) throw InputError(place, "a ** is not closed");
    const std::string key(text.substr(strong.size(), close - strong.size()));
    if (std::ranges::find(keys, key) == keys.end()) throw InputError(place, "unknown key " + key);
    text.remove_prefix(close + strong.size());
    const std::size_t next = std::min(text.find(strong), text.size());
    if (!values.emplace(key, flat(text.substr(0, next))).second) throw InputError(place, key + " stands twice");
    text.remove_prefix(next);
  }
  for (const std::string_view key : keys) {
    if (key != "Freedom" && values[std::string(key)].empty()) throw InputError(place, "no " + std::string(key));
  }
  return values;
}

Clause parse_clause(std::string_view block, const std::string& query) {
  const std::size_t line_end = std::min(block.find('\n'), block.size());
  const std::string_view head = block.substr(0, line_end);
  const std::size_t dot = head.find(id_end);
  if (dot == std::string_view::npos)
    throw InputError("docs/spec/" + query + ".md", "no title in: " + std::string(head));
  Clause clause;
  clause.query = query;
  clause.id = head.substr(0, dot);
  clause.title = flat(head.substr(dot + id_end.size()));
  const std::string place = "docs/spec/" + query + ".md, " + clause.id;
  const std::string_view body = block.substr(line_end);
  const std::size_t first_key = std::min(body.find(strong), body.size());
  clause.says = flat(body.substr(0, first_key));
  if (clause.says.empty()) throw InputError(place, "no sentence");
  auto values = keyed(body.substr(first_key), place);
  clause.domain = values["Domain"];
  clause.truth = values["Truth"];
  clause.allowed = values["Allowed"];
  clause.freedom = values["Freedom"];
  clause.source = values["Source"];
  clause.checked_by = names(values["Checked by"]);
  clause.sharp_by = names(values["Proved sharp by"]);
  return clause;
}

std::vector<Clause> read_all() {
  std::vector<Clause> all;
  for (const std::string& query : oracle::query_names()) {
    const auto page = std::ranges::find(spec_pages(), query, &SpecPage::query);
    if (page == spec_pages().end()) continue;  // its clauses are on the page of another query
    for (Clause& clause : parse_clauses(page->text, query)) all.push_back(std::move(clause));
  }
  return all;
}

}  // namespace

std::vector<Clause> parse_clauses(std::string_view page, const std::string& query) {
  std::vector<Clause> found;
  std::size_t at = page.find(heading);
  while (at != std::string_view::npos) {
    const std::size_t next = page.find(heading, at + heading.size());
    found.push_back(parse_clause(page.substr(at + heading.size(), next - at - heading.size()), query));
    at = next;
  }
  return found;
}

const std::vector<Clause>& clauses() {
  static const std::vector<Clause> all = read_all();
  return all;
}

const Clause& clause(const std::string& id) {
  const auto found = std::ranges::find(clauses(), id, &Clause::id);
  if (found == clauses().end()) throw InputError("clause " + id, "unknown; `touchstone list clauses` has them all");
  return *found;
}

}  // namespace touchstone::properties
