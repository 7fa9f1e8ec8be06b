#include <fmt/format.h>

#include "app/report/page.h"
#include "app/report/xml.h"

namespace touchstone::app::page {
namespace {

std::string without_query(const std::string& id) { return id.substr(id.find('.') + 1); }

std::string counts_of(const Row& row) {
  return fmt::format(
      "holds {}, fails {}, breaks {}, refused {}, abstains {}, outside {}, beyond its domain {}, not asked {}",
      row.counts.holds, row.counts.fails, row.counts.breaks, row.counts.refused, row.counts.abstains,
      row.counts.outside, row.counts.beyond, row.counts.not_asked);
}

std::string silence_of(const Row& row) {
  if (row.counts.abstains > 0) return "abstains";
  if (row.counts.beyond > 0) return "beyond its domain";
  return row.counts.not_asked > 0 ? "not asked" : "outside";
}

std::string cell(const Row& row) {
  const auto grade = row.grade();
  if (!grade) return fmt::format("<td class=\"none\" title=\"{}\">{}</td>", counts_of(row), silence_of(row));
  const std::string name = oracle::name_of(*grade);
  const std::string words = row.failing()
                                ? fmt::format("<a href=\"#{}\"><b>{}</b> {}</a>", anchor(row), name, share_of(row))
                                : fmt::format("<b>{}</b> {} hold", name, row.counts.holds);
  return fmt::format("<td class=\"{}\" title=\"{}\">{}</td>", name, counts_of(row), words);
}

std::string query_row(const Ledger& ledger, const std::string& query) {
  return fmt::format("<tr class=\"query\"><th scope=\"rowgroup\">{}</th><td colspan=\"{}\">{}</td></tr>", query,
                     ledger.subjects.size(), plural(ledger.scenes.at(query), "scene"));
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

}  // namespace

std::string table(const Ledger& ledger) {
  std::string html = legend;
  html +=
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Properties and subjects\"><table><thead><tr>"
      "<th scope=\"col\">property</th>";
  for (const TestedSubject& subject : ledger.subjects) {
    html += "<th scope=\"col\">" + escaped(subject.card.name) + "</th>";
  }
  html += "</tr></thead><tbody>";
  std::string query;
  for (const properties::Property* property : ledger.results.tested_properties()) {
    if (property->query != query) html += query_row(ledger, query = property->query);
    html += fmt::format("<tr><th scope=\"row\" title=\"{}\">{}</th>", escaped(property->says),
                        escaped(without_query(property->id)));
    for (const Row& row : ledger.results.of(*property)) html += cell(row);
    html += "</tr>";
  }
  return html + "</tbody></table></div>";
}

}  // namespace touchstone::app::page
