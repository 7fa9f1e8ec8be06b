#include "app/report_html.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "app/picture.h"
#include "app/report_style.h"
#include "app/version.h"
#include "app/xml.h"
#include "oracle/words.h"
#include "properties/clause.h"
#include "properties/property.h"

namespace touchstone::app {
namespace {

using oracle::Grade;

constexpr std::size_t longest_text = 600;  // of an engine's words: a list of 300 pairs is not read

std::string shown(const std::string& text) {
  return escaped(text.size() <= longest_text ? text : text.substr(0, longest_text) + " …");
}

std::string anchor(const Row& row) { return escaped(row.property + "." + row.subject); }

std::string letter(Grade grade) { return fmt::format("<span class=\"g {0}\">{0}</span>", oracle::name_of(grade)); }

long answered(const Row& row) { return row.holds + row.fails + row.breaks; }

std::string cell(const Row& row) {
  const auto grade = row.grade();
  if (!grade) {
    const bool abstains = row.abstains > 0;
    return fmt::format("<td class=\"none\" title=\"{}\">{}</td>", escaped(row.why_abstains),
                       abstains            ? "abstains"
                       : row.not_asked > 0 ? "not asked"
                                           : "outside");
  }
  const std::string name = oracle::name_of(*grade);
  if (!row.failing()) return fmt::format("<td class=\"{0}\"><b>{0}</b> {1}</td>", name, row.holds);
  return fmt::format("<td class=\"{0}\"><a href=\"#{1}\"><b>{0}</b> {2} of {3} fail</a></td>", name, anchor(row),
                     row.fails + row.breaks, answered(row));
}

std::string matrix(const Ledger& ledger) {
  std::string html =
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"properties and "
      "subjects\"><table><thead><tr><th>property</th>";
  for (const oracle::Card& card : ledger.subjects) html += "<th scope=\"col\">" + escaped(card.name) + "</th>";
  html += "</tr></thead><tbody>";
  std::string stem;
  for (std::size_t r = 0; r < ledger.rows.size(); r += ledger.subjects.size()) {
    const properties::Property& property = properties::find(ledger.rows[r].property);
    if (property.stem != stem) {
      stem = property.stem;
      html += fmt::format(
          "<tr class=\"stem\"><th scope=\"rowgroup\">{}</th><td colspan=\"{}\" class=\"none\">{} scenes</td></tr>",
          stem, ledger.subjects.size(), ledger.scenes.at(stem));
    }
    html += fmt::format("<tr><th scope=\"row\" title=\"{}\">{}</th>", escaped(property.says), escaped(property.id));
    for (std::size_t s = 0; s < ledger.subjects.size(); ++s) html += cell(ledger.rows[r + s]);
    html += "</tr>";
  }
  return html + "</tbody></table></div>";
}

struct Summary {
  int hold = 0;
  int fail = 0;
  int silent = 0;
  std::array<long, 5> grades{};
};

Summary summary_of(const Ledger& ledger, const std::string& subject) {
  Summary summary;
  for (const Row& row : ledger.rows) {
    if (row.subject != subject) continue;
    ++(row.failing() ? summary.fail : row.holds > 0 ? summary.hold : summary.silent);
    for (std::size_t g = 0; g < row.grades.size(); ++g) summary.grades[g] += row.grades[g];
  }
  return summary;
}

std::string subject_card(const Ledger& ledger, const oracle::Card& card) {
  const Summary summary = summary_of(ledger, card.name);
  std::string html = fmt::format(
      "<section class=\"card\"><h3>{} <small>{}</small></h3><p>{} properties hold, {} fail, {} not answered</p><p>",
      escaped(card.name), escaped(card.version), summary.hold, summary.fail, summary.silent);
  for (std::size_t g = 0; g < summary.grades.size(); ++g) {
    html += fmt::format("{}{} ", letter(static_cast<Grade>(g)), summary.grades[g]);
  }
  html += fmt::format("</p><p class=\"soft\">{}</p>", escaped(card.about));
  for (const oracle::Deviation& known : card.deviations) {
    html += fmt::format("<p><small>Known: {}", escaped(known.what));
    if (known.link.starts_with("http")) html += fmt::format(" <a href=\"{0}\">{0}</a>", escaped(known.link));
    html += "</small></p>";
  }
  return html + "</section>";
}

std::string definition(const char* term, const std::string& text) {
  return text.empty() ? "" : fmt::format("<dt>{}</dt><dd>{}</dd>", term, text);
}

std::string clause_words(const properties::Property& property) {
  std::string words;
  for (const std::string& id : property.clauses) {
    const properties::Clause& clause = properties::clause(id);
    words += fmt::format("<b>{}</b> {} ", escaped(clause.id), escaped(clause.says));
  }
  return words;
}

std::string failing_article(const Row& row) {
  const properties::Property& property = properties::find(row.property);
  const bool cut = row.smallest_case.has_value();
  const oracle::Finding& finding = cut ? row.smallest_case->finding : row.worst->finding;
  const std::string drawing = cut ? picture(row.smallest_case->scene) : "";
  std::string facts;
  facts += definition("defect", fmt::format("{} in {} of {}", escaped(oracle::name_of(finding.defect)),
                                            row.fails + row.breaks, answered(row)));
  facts += definition("observed", shown(finding.observed));
  facts += definition("expected", shown(finding.expected));
  if (!finding.unit.empty()) {
    facts += definition(
        "error", fmt::format("{:.4g} {}; allowed {:.4g}", finding.error, escaped(finding.unit), finding.allowed));
  }
  if (finding.margin)
    facts += definition("margin", escaped(oracle::words::text(*finding.margin)) + " m from another truth");
  facts += definition("because", shown(finding.why));
  facts += definition("worst seen", fmt::format("{} in {} {}", escaped(oracle::name_of(row.worst->finding.defect)),
                                                escaped(row.worst->family), row.worst->index));
  if (cut) {
    const oracle::Size size = oracle::size_of(row.smallest_case->scene);
    facts += definition(
        "scene",
        fmt::format("{} bodies, at most {} vertices a body and {} significant bits (found: {} vertices, {} bits)",
                    size.bodies, size.vertices_per_body_max, size.significant_bits_max,
                    row.size_found.vertices_per_body_max, row.size_found.significant_bits_max));
    facts += definition("note", escaped(row.smallest_case->note));
    facts += definition(
        "replay", fmt::format("<code>touchstone replay {0}</code> <a href=\"{0}\">file</a>", escaped(row.case_file)));
  }
  facts += definition("clause", clause_words(property));
  return fmt::format("<article id=\"{}\"{}>{}<div><h3>{}{}</h3><p class=\"soft\">{}</p><dl>{}</dl></div></article>",
                     anchor(row), drawing.empty() ? "" : " class=\"drawn\"",
                     drawing.empty() ? "" : "<div>" + drawing + "</div>", letter(*row.grade()), escaped(row.property),
                     escaped(property.says), facts);
}

std::string failures_of(const Ledger& ledger, const oracle::Card& card) {
  std::string articles;
  int count = 0;
  for (const Row& row : ledger.rows) {
    if (row.subject != card.name || !row.failing()) continue;
    articles += failing_article(row);
    ++count;
  }
  if (count == 0) return fmt::format("<p>{}: none.</p>", escaped(card.name));
  return fmt::format("<details open><summary>{}: {} failing</summary>{}</details>", escaped(card.name), count,
                     articles);
}

std::string asked(const Ledger& ledger) {
  std::string html =
      fmt::format("<p>Seed {}, effort {}, {} drawn scenes a stem. ", ledger.seed, ledger.effort, ledger.cases);
  if (ledger.meshes_absent.empty() && ledger.mesh_count > 0) {
    html += fmt::format("Real input: {} convex robot meshes; scenes:", ledger.mesh_count);
    for (const auto& [family, count] : ledger.mesh_scenes) html += fmt::format(" {} {},", escaped(family), count);
    html.back() = '.';
  } else {
    html += "<b>No real meshes:</b> " +
            escaped(ledger.meshes_absent.empty() ? "none were asked for." : ledger.meshes_absent + ".");
  }
  html += "</p>";
  if (ledger.empty_classes.empty()) {
    html += "<p>Every kind of case that a stem needs was met.</p>";
  } else {
    html += fmt::format("<p><b>Kinds of case that were not met:</b> {}</p>",
                        escaped(fmt::format("{}", fmt::join(ledger.empty_classes, "; "))));
  }
  html += "<details><summary>Scenes of each kind</summary><div class=\"scroll\"><table><tbody>";
  for (const auto& [stem, classes] : ledger.classes) {
    html += fmt::format("<tr class=\"stem\"><th>{}</th><td></td></tr>", escaped(stem));
    for (const auto& [name, count] : classes)
      html += fmt::format("<tr><th>{}</th><td>{}</td></tr>", escaped(name), count);
  }
  return html + "</tbody></table></div></details>";
}

constexpr const char* legend =
    R"html(<p><span class="g A">A</span>holds: within what rounding in the engine's own precision explains
<span class="g B">B</span>wrong by up to 2¹⁰ times that <span class="g C">C</span>up to 2²⁰ times <span class="g D">D</span>beyond, or a broken law
<span class="g F">F</span>a wrong verdict or pair, or no answer at all (crash, hang, NaN). A row's grade is its worst. “abstains”: the engine does not
offer this; that is no pass. “outside”: no scene of the property's domain is exact in the engine's precision.</p>)html";

constexpr const char* limitations =
    R"html(<ul><li>Scenes are drawn near-degenerate on purpose: the share of failures says nothing about how
often an engine is wrong in use.</li><li>Engines are asked raw queries with margin 0 where they offer it; in use they add margins that hide some of this.</li>
<li>An engine gets the unit quaternion in its own precision. That rounding is part of what is allowed, not of the engine's error.</li>
<li>The cut-down scene shows one defect of a row; others may hide behind it.</li><li>Penetration depth is judged for convex bodies only.</li></ul>)html";

}  // namespace

std::string report_html(const Ledger& ledger) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width,initial-scale=1\">"
      "<link rel=\"icon\" href=\"data:,\"><title>Touchstone "
      "report</title><style>{}</style></head><body><header><h1>Who is wrong, by how much, on what</h1>"
      "<p class=\"soft\">Touchstone {}: engines asked about collision scenes whose exact answer is known.</p>{}"
      "<nav><a href=\"#table\">Table</a><a href=\"#subjects\">Subjects</a><a href=\"#failures\">Smallest failing "
      "scenes</a><a href=\"#asked\">What was asked</a>"
      "<a href=\"#limits\">Limits</a></nav></header><main>",
      report_style, version, ledger.interrupted ? "<p><b>Interrupted: this report is partial.</b></p>" : "");
  html += "<h2 id=\"table\">Properties and subjects</h2>" + std::string(legend) + matrix(ledger);
  html += "<h2 id=\"subjects\">Subjects</h2><div class=\"cards\">";
  for (const oracle::Card& card : ledger.subjects) html += subject_card(ledger, card);
  html +=
      "</div><h2 id=\"failures\">Smallest failing scenes</h2><p>Body A is drawn solid, body B dashed; between them the "
      "exact closest points.</p>";
  for (const oracle::Card& card : ledger.subjects) html += failures_of(ledger, card);
  html += "<h2 id=\"asked\">What was asked</h2>" + asked(ledger);
  html += "<h2 id=\"limits\">Limits</h2>" + std::string(limitations);
  return html + "</main></body></html>\n";
}

}  // namespace touchstone::app
