#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/report/page/page.h"
#include "app/report/xml.h"

namespace touchstone::app::page {
namespace {

std::string without_query(const std::string& id) { return id.substr(id.find('.') + 1); }

std::string counts_of(const Row& row) {
  return fmt::format(
      "holds {}, fails {}, breaks {}, refused {}, abstains {}, outside {}, beyond its domain {}, not asked {}, "
      "without an answer {}",
      row.counts.holds, row.counts.fails, row.counts.breaks, row.counts.refused, row.counts.abstains,
      row.counts.outside, row.counts.beyond, row.counts.not_asked, row.counts.unanswered);
}

std::string cell(const Row& row) {
  const auto grade = row.grade();
  if (!grade) return fmt::format("<td class=\"none\" title=\"{}\">{}</td>", counts_of(row), silence_of(row.counts));
  const std::string name = oracle::name_of(*grade);
  const std::string words = row.failing()
                                ? fmt::format("<a href=\"#{}\"><b>{}</b> {}</a>", anchor(row), name, share_of(row))
                                : fmt::format("<b>{}</b> {} hold", name, row.counts.holds);
  return fmt::format("<td class=\"{}\" title=\"{}\">{}</td>", name, counts_of(row), words);
}

constexpr const char* legend = R"html(<dl class="legend">
<dt><span class="g A">A</span></dt><dd>holds: within what rounding in the engine’s own precision explains</dd>
<dt><span class="g A-">A-</span></dt><dd>on the side that the clause forbids, but within rounding: a box not rounded outward</dd>
<dt><span class="g B">B</span></dt><dd>wrong by up to 2¹⁰ times that</dd>
<dt><span class="g C">C</span></dt><dd>up to 2²⁰ times</dd>
<dt><span class="g D">D</span></dt><dd>beyond: an absolute epsilon, a wrong formula, a broken law; or a refusal: the engine says that it does not take the scene</dd>
<dt><span class="g F">F</span></dt><dd>a wrong verdict or pair, no right digit (0 for 0.83 m), or no answer at all: crash, hang, NaN</dd>
</dl><p class="soft">A cell’s grade is the worst that was seen. <i>abstains</i>: the engine does not offer this; that is no pass.
<i>outside</i>: no scene of the property’s domain has numbers that the engine’s precision can hold.
<i>beyond its domain</i>: each scene is outside what the engine’s card declares, and counted apart.</p>)html";

using Properties = ResultMatrix::Properties;

/// For each subject whether it answers any of the properties.
std::vector<bool> answering_subjects(const Ledger& ledger, const Properties& properties) {
  std::vector<bool> answers(ledger.subjects.size(), false);
  for (const properties::Property* property : properties) {
    for (const Row& row : ledger.results.of(*property)) {
      if (row.answered() > 0) answers[row.subject->index] = true;
    }
  }
  return answers;
}

std::string head_row(const Ledger& ledger, const std::vector<bool>& answers) {
  std::string html = "<tr><th scope=\"col\">property</th>";
  for (const TestedSubject& subject : ledger.subjects) {
    if (!answers[subject.index]) continue;
    html += fmt::format("<th scope=\"col\" data-subject=\"{}\">{}</th>", escaped(subject.card.name),
                        breakable(subject.card.name));
  }
  return html + "</tr>";
}

std::string property_row(const Ledger& ledger, const properties::Property& property, const std::vector<bool>& answers) {
  std::string html = fmt::format("<tr data-property=\"{}\"><th scope=\"row\">{}<small>{}</small></th>",
                                 escaped(property.id), breakable(without_query(property.id)), escaped(property.says));
  for (const Row& row : ledger.results.of(property)) {
    if (answers[row.subject->index]) html += cell(row);
  }
  return html + "</tr>";
}

std::string silent_subjects(const Ledger& ledger, const std::vector<bool>& answers) {
  std::vector<std::string> names;
  for (const TestedSubject& subject : ledger.subjects) {
    if (!answers[subject.index]) names.push_back(escaped(subject.card.name));
  }
  if (names.empty()) return "";
  return fmt::format("<details><summary>{} no answer</summary><p class=\"soft\">{}</p></details>",
                     names.size() == 1 ? "1 subject gives" : fmt::format("{} subjects give", names.size()),
                     fmt::join(names, ", "));
}

std::string table(const Ledger& ledger, const Properties& properties) {
  const std::string& query = properties.front()->query;
  const std::vector<bool> answers = answering_subjects(ledger, properties);
  const long answering = std::ranges::count(answers, true);
  std::string html = fmt::format("<section id=\"{}\"><h3>{} <small>{}, {} of {}</small></h3>", table_anchor(query),
                                 query, plural(ledger.scenes.at(query), "scene"), answering,
                                 plural(static_cast<long>(answers.size()), "subject"));
  if (answering > 0) {
    std::string rows;
    for (const properties::Property* property : properties) rows += property_row(ledger, *property, answers);
    html += scrolling("Properties of " + query,
                      fmt::format("<table class=\"by-subject\"><thead>{}</thead><tbody>{}</tbody></table>",
                                  head_row(ledger, answers), rows));
  }
  return html + silent_subjects(ledger, answers) + "</section>";
}

}  // namespace

std::string tables(const Ledger& ledger) {
  std::string html = legend;
  for (const Properties& properties : ledger.results.by_query()) html += table(ledger, properties);
  return html;
}

}  // namespace touchstone::app::page
