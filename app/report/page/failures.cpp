#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "app/report/finding_words.h"
#include "app/report/page/page.h"
#include "app/report/page/picture.h"
#include "app/report/xml.h"
#include "app/trial/causes.h"
#include "properties/clause.h"

namespace touchstone::app::page {
namespace {

std::string clause_words(const properties::Property& property) {
  std::string words;
  for (const std::string& id : property.clauses) {
    const properties::Clause& clause = properties::clause(id);
    words += fmt::format("<b>{}</b> {} ", escaped(clause.id), escaped(clause.says));
  }
  return words;
}

/// Programs in the engine's own API, one for each scene of the case.
std::string snippets(const oracle::Case& a_case) {
  const auto listing = [](const std::string& snippet) {
    return snippet.empty() ? "" : fmt::format("<pre>{}</pre>", escaped(snippet));
  };
  return listing(a_case.snippet) + (a_case.changed ? listing(a_case.changed->snippet) : "");
}

std::string about_the_case(const Row& row) {
  if (!row.minimised.result) return "";
  const oracle::Size size = oracle::size_of(row.minimised.result->scene);
  return definition("scene",
                    fmt::format("{}; drawn as {} {} with {}", text_of(size), escaped(row.examples.smallest->family),
                                row.examples.smallest->index, text_of(row.minimised.size_before))) +
         definition("asked of", row.minimised.result->changed ? escaped(row.minimised.result->changed->how) : "") +
         definition("outside", escaped(row.examples.smallest->beyond)) +
         definition("note", escaped(row.minimised.result->note)) +
         definition("in its own calls", snippets(*row.minimised.result)) +
         definition("replay", fmt::format("<code>{}</code> <a href=\"{}\">file</a>",
                                          escaped(row.minimised.replay_command), escaped(row.minimised.case_file)));
}

std::string facts(const Row& row) {
  const oracle::Finding& finding = shown_finding(row);
  std::string html;
  for (const auto& [label, words] : lines_of(finding)) html += definition(label, shown(words));
  html += definition("proof", shown(finding.certificate));
  html += definition("clause", clause_words(*row.property));
  return html + about_the_case(row);
}

/// The scene and, of a law about two answers, the second one. The two stand one below the other.
std::string drawings(const oracle::Case& a_case) {
  const std::string first = picture(a_case);
  if (!a_case.changed) return first;
  const std::string second = picture(a_case.changed->scene);
  if (first.empty() || second.empty()) return first + second;
  return fmt::format("<div>{}<p class=\"soft\">then asked of {}:</p>{}</div>", first, escaped(a_case.changed->how),
                     second);
}

std::string failing_row(const Row& row) {
  const std::string drawing = row.minimised.result ? drawings(*row.minimised.result) : "";
  return fmt::format(
      "<details class=\"row\" id=\"{0}\" data-property=\"{2}\"><summary>{1}<b>{2}</b> <span class=\"soft\">{3}, "
      "{4}</span></summary><p class=\"soft\">Must hold: {5}.</p><div class=\"{6}\">{7}<dl>{8}</dl></div></details>",
      anchor(row), badge(*row.grade()), escaped(row.property->id), escaped(oracle::name_of(shown_finding(row).defect)),
      share_of(row), escaped(row.property->says), drawing.empty() ? "plain" : "drawn", drawing, facts(row));
}

std::string failing_rows(const std::vector<const Row*>& rows) {
  std::string html;
  for (const Row* row : rows) html += failing_row(*row);
  return html;
}

/// One break that shows in many rows is one entry.
std::string cause_of(const Cause& cause) {
  if (cause.rows.size() == 1) return failing_rows(cause.rows);
  return fmt::format("<details class=\"cause\"><summary>One cause in {} rows: {}</summary>{}</details>",
                     cause.rows.size(), shown(shown_finding(*cause.rows.front()).why), failing_rows(cause.rows));
}

/// Empty if nothing fails.
std::string failures_of(const ResultMatrix& results, const TestedSubject& subject, const std::string& id,
                        const char* where) {
  const std::vector<Cause> all = causes(results, subject);
  std::string html;
  std::size_t rows = 0;
  for (const Cause& cause : all) {
    html += cause_of(cause);
    rows += cause.rows.size();
  }
  if (rows == 0) return "";
  std::string count = plural(static_cast<long>(rows), "failing row");
  if (all.size() < rows) count += fmt::format(" of {}", plural(static_cast<long>(all.size()), "cause"));
  return fmt::format("<section id=\"{0}\" data-subject=\"{1}\"><h3>{1}{2}: {3}</h3>{4}</section>", id,
                     escaped(subject.card.name), where, count, html);
}

}  // namespace

std::string failures(const Ledger& ledger) {
  std::string html =
      "<p>Each opens to its smallest failing scene. <span class=\"soft\">The commands run from any folder of the "
      "machine "
      "that wrote this page. Elsewhere: <code>./touchstone replay</code> with the linked file, and "
      "<code>--subject</code> for an engine of your own.</span></p>";
  std::vector<std::string> right;
  for (const TestedSubject& subject : ledger.subjects) {
    const std::string id = failures_anchor(subject);
    const std::string inside = failures_of(ledger.results, subject, id, "");
    if (inside.empty()) right.push_back(escaped(subject.card.name));
    html += inside;
    html += failures_of(ledger.beyond, subject, id + ".beyond", ", outside its declared domain");
  }
  if (right.empty()) return html;
  return html + fmt::format("<p>Without a failing row: {}.</p>", fmt::join(right, ", "));
}

}  // namespace touchstone::app::page
