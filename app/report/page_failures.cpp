#include <fmt/format.h>

#include "app/report/finding_words.h"
#include "app/report/page.h"
#include "app/report/picture.h"
#include "app/report/xml.h"
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
  const std::string first = picture(a_case.scene);
  if (!a_case.changed) return first;
  const std::string second = picture(a_case.changed->scene);
  if (first.empty() || second.empty()) return first + second;
  return fmt::format("<div>{}<p class=\"soft\">then asked of {}:</p>{}</div>", first, escaped(a_case.changed->how),
                     second);
}

std::string failing_row(const Row& row) {
  const std::string drawing = row.minimised.result ? drawings(*row.minimised.result) : "";
  return fmt::format(
      "<details class=\"row\" id=\"{}\"><summary>{}<b>{}</b> <span class=\"soft\">{}, {}</span></summary>"
      "<p class=\"soft\">Must hold: {}.</p><div class=\"{}\">{}<dl>{}</dl></div></details>",
      anchor(row), badge(*row.grade()), escaped(row.property->id), escaped(oracle::name_of(shown_finding(row).defect)),
      share_of(row), escaped(row.property->says), drawing.empty() ? "plain" : "drawn", drawing, facts(row));
}

std::string failures_of(const ResultMatrix& results, const TestedSubject& subject, const char* where) {
  std::string rows;
  int count = 0;
  for (const Row* row : results.of(subject)) {
    if (!row->failing()) continue;
    rows += failing_row(*row);
    ++count;
  }
  return fmt::format("<section><h3>{}{}: {}</h3>{}</section>", escaped(subject.card.name), where,
                     count == 0 ? "nothing fails" : plural(count, "failing row"), rows);
}

bool declares_domain(const TestedSubject& subject) { return !(subject.card.domain == oracle::Domain{}); }

}  // namespace

std::string failures(const Ledger& ledger) {
  std::string html =
      "<p>Each opens to its smallest failing scene. <span class=\"soft\">The commands run from any folder of the "
      "machine "
      "that wrote this page. Elsewhere: <code>./touchstone replay</code> with the linked file, and "
      "<code>--subject</code> "
      "for an engine of your own.</span></p>";
  for (const TestedSubject& subject : ledger.subjects) {
    html += failures_of(ledger.results, subject, "");
    if (declares_domain(subject)) html += failures_of(ledger.beyond, subject, ", outside its declared domain");
  }
  return html;
}

}  // namespace touchstone::app::page
