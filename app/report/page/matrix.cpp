#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "app/report/page/page.h"
#include "app/report/xml.h"

namespace touchstone::app::page {
namespace {

/// What a subject's answers to one query, or to all, came to.
struct Verdict {
  int answered = 0;  ///< properties
  int hold = 0;      ///< properties
  Counts counts;     ///< scenes, of all properties
  std::optional<oracle::Grade> worst;
  std::string why_abstains;

  void add(const Row& row) {
    counts += row.counts;
    if (why_abstains.empty()) why_abstains = row.why_abstains;
    if (row.answered() == 0) return;
    ++answered;
    hold += row.failing() ? 0 : 1;
    worst = std::max(worst, row.grade());
  }
};

std::string silent_cell(const Verdict& verdict) {
  const std::string silence = silence_of(verdict.counts);
  if (silence != "abstains") return fmt::format("<td class=\"none\">{}</td>", silence);
  return fmt::format("<td class=\"none\" title=\"{}\">–</td>", escaped(verdict.why_abstains));
}

std::string cell(const Verdict& verdict, const std::string& link) {
  if (verdict.answered == 0) return silent_cell(verdict);
  const long failures = verdict.counts.failures();
  const std::string share = failures == 0 ? "" : percent(failures, verdict.counts.answered()) + " fail";
  return fmt::format(
      "<td class=\"share\" style=\"--share:{:.2f}\" title=\"{} of {} answers fail\"><a href=\"#{}\">{}{} of {}<small> "
      "{}</small></a></td>",
      static_cast<double>(verdict.hold) / verdict.answered, failures, verdict.counts.answered(), link,
      badge(*verdict.worst), verdict.hold, verdict.answered, share);
}

std::string row_of(const Ledger& ledger, const TestedSubject& subject) {
  Verdict all;
  std::string cells;
  for (const ResultMatrix::Properties& properties : ledger.results.by_query()) {
    Verdict verdict;
    for (const properties::Property* property : properties) {
      const Row& row = ledger.results.of(*property)[subject.index];
      verdict.add(row);
      all.add(row);
    }
    cells += cell(verdict, table_anchor(properties.front()->query));
  }
  const std::string name = escaped(subject.card.name);
  return fmt::format("<tr data-subject=\"{0}\"><th scope=\"row\"><a href=\"#{1}\">{0}</a></th>{2}{3}</tr>", name,
                     subject_anchor(subject), cell(all, subject_anchor(subject)), cells);
}

}  // namespace

std::string matrix(const Ledger& ledger) {
  std::string table = "<table class=\"matrix\"><thead><tr><th scope=\"col\">subject</th><th scope=\"col\">all</th>";
  for (const ResultMatrix::Properties& properties : ledger.results.by_query()) {
    const std::string& query = properties.front()->query;
    table += fmt::format("<th scope=\"col\"><a href=\"#{}\">{}</a></th>", table_anchor(query), breakable(query));
  }
  table += "</tr></thead><tbody>";
  for (const TestedSubject& subject : ledger.subjects) table += row_of(ledger, subject);
  return "<p>Properties that hold, of those that the subject answers; then the share of its answers that fail. The "
         "letter is the <a href=\"#table\">worst grade</a> of any answer; the darker, the more properties hold. – : "
         "the "
         "subject does not offer the query.</p>" +
         scrolling("Properties that hold", table + "</tbody></table>");
}

}  // namespace touchstone::app::page
