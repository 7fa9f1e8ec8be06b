#include "app/report_html.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "app/finding_words.h"
#include "app/picture.h"
#include "app/report_style.h"
#include "app/version.h"
#include "app/xml.h"
#include "properties/clause.h"
#include "properties/property.h"

namespace touchstone::app {
namespace {

using oracle::Grade;

constexpr std::size_t longest_text = 600;  // of an engine's words: a list of 300 pairs is not read

/// Cut between characters, not inside one.
std::string shown(const std::string& text) {
  std::size_t end = std::min(text.size(), longest_text);
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return escaped(end == text.size() ? text : text.substr(0, end) + " …");
}

std::string anchor(const Row& row) { return escaped(row.property + "." + row.subject); }

std::string badge(Grade grade) { return fmt::format("<span class=\"g {0}\">{0}</span>", oracle::name_of(grade)); }

std::string without_stem(const std::string& id) { return id.substr(id.find('.') + 1); }

std::string plural(long count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

long total(const std::map<std::string, long>& counts) {
  long sum = 0;
  for (const auto& [name, count] : counts) sum += count;
  return sum;
}

// ---- the table ----

std::string counts_of(const Row& row) {
  return fmt::format("holds {}, fails {}, breaks {}, abstains {}, outside {}, not asked {}", row.holds, row.fails,
                     row.breaks, row.abstains, row.outside, row.not_asked);
}

std::string silence_of(const Row& row) {
  if (row.abstains > 0) return "abstains";
  return row.not_asked > 0 ? "not asked" : "outside";
}

std::string cell(const Row& row) {
  const auto grade = row.grade();
  if (!grade) return fmt::format("<td class=\"none\" title=\"{}\">{}</td>", counts_of(row), silence_of(row));
  const std::string name = oracle::name_of(*grade);
  const std::string words = row.failing() ? fmt::format("<a href=\"#{}\"><b>{}</b> {} of {} fail</a>", anchor(row),
                                                        name, row.fails + row.breaks, row.answered())
                                          : fmt::format("<b>{}</b> {} hold", name, row.holds);
  return fmt::format("<td class=\"{}\" title=\"{}\">{}</td>", name, counts_of(row), words);
}

std::string stem_row(const Ledger& ledger, const std::string& stem) {
  return fmt::format("<tr class=\"stem\"><th scope=\"rowgroup\">{}</th><td colspan=\"{}\">{}</td></tr>", stem,
                     ledger.subjects.size(), plural(ledger.scenes.at(stem), "scene"));
}

std::string matrix(const Ledger& ledger) {
  std::string html =
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Properties and subjects\"><table><thead><tr>"
      "<th scope=\"col\">property</th>";
  for (const oracle::Card& card : ledger.subjects) html += "<th scope=\"col\">" + escaped(card.name) + "</th>";
  html += "</tr></thead><tbody>";
  std::string stem;
  for (std::size_t r = 0; r < ledger.rows.size(); r += ledger.subjects.size()) {
    const properties::Property& property = properties::find(ledger.rows[r].property);
    if (property.stem != stem) html += stem_row(ledger, stem = property.stem);
    html += fmt::format("<tr><th scope=\"row\" title=\"{}\">{}</th>", escaped(property.says),
                        escaped(without_stem(property.id)));
    for (std::size_t s = 0; s < ledger.subjects.size(); ++s) html += cell(ledger.rows[r + s]);
    html += "</tr>";
  }
  return html + "</tbody></table></div>";
}

constexpr const char* legend = R"html(<dl class="legend">
<dt><span class="g A">A</span></dt><dd>holds: within what rounding in the engine’s own precision explains</dd>
<dt><span class="g B">B</span></dt><dd>wrong by up to 2¹⁰ times that</dd>
<dt><span class="g C">C</span></dt><dd>up to 2²⁰ times</dd>
<dt><span class="g D">D</span></dt><dd>beyond: an absolute epsilon, a wrong formula, a broken law</dd>
<dt><span class="g F">F</span></dt><dd>a wrong verdict or pair, or no answer at all: crash, hang, NaN</dd>
</dl><p class="soft">A cell’s grade is the worst that was seen. <i>abstains</i>: the engine does not offer this; that is no pass.
<i>outside</i>: no scene of the property’s domain has numbers that the engine’s precision can hold.</p>)html";

// ---- one subject ----

struct Summary {
  int hold = 0;
  int fail = 0;
  int silent = 0;
  std::array<long, 5> grades{};
  const Row* most_wrong = nullptr;                          ///< by ulps of the scene's scale
  std::map<std::string, std::vector<std::string>> silence;  ///< why -> properties
};

Summary summary_of(const Ledger& ledger, const std::string& subject) {
  Summary summary;
  for (const Row& row : ledger.rows) {
    if (row.subject != subject) continue;
    ++(row.failing() ? summary.fail : row.holds > 0 ? summary.hold : summary.silent);
    for (std::size_t g = 0; g < row.grades.size(); ++g) summary.grades[g] += row.grades[g];
    if (row.answered() == 0 && row.abstains > 0) summary.silence[row.why_abstains].push_back(row.property);
    if (row.unit.starts_with("ulps") &&
        (summary.most_wrong == nullptr || row.largest_error > summary.most_wrong->largest_error)) {
      summary.most_wrong = &row;
    }
  }
  return summary;
}

std::string grades(const Summary& summary) {
  std::string bar;
  std::string tally;
  for (std::size_t g = 0; g < summary.grades.size(); ++g) {
    const std::string name = oracle::name_of(static_cast<Grade>(g));
    if (summary.grades[g] > 0)
      bar += fmt::format("<i class=\"{}\" style=\"flex:{} 1 2px\"></i>", name, summary.grades[g]);
    tally += fmt::format("<li>{}{}</li>", badge(static_cast<Grade>(g)), summary.grades[g]);
  }
  return fmt::format("<div class=\"bar\" aria-hidden=\"true\">{}</div><ul class=\"tally\">{}</ul>", bar, tally);
}

std::string silences(const Summary& summary) {
  if (summary.silence.empty()) return "";
  std::string html = fmt::format("<details><summary>Abstains from {}</summary><ul>", plural(summary.silent, "row"));
  for (const auto& [why, ids] : summary.silence) {
    html += fmt::format("<li>{}: {}</li>", escaped(why), escaped(fmt::format("{}", fmt::join(ids, ", "))));
  }
  return html + "</ul></details>";
}

std::string deviations(const oracle::Card& card) {
  if (card.deviations.empty()) return "";
  std::string html = "<p>Known, which explains and excuses nothing:</p><ul>";
  for (const oracle::Deviation& known : card.deviations) {
    html += "<li>" + escaped(known.what);
    if (known.link.starts_with("http")) html += fmt::format(" (<a href=\"{}\">issue</a>)", escaped(known.link));
    html += "</li>";
  }
  return html + "</ul>";
}

std::string subject_card(const Ledger& ledger, const oracle::Card& card) {
  const Summary summary = summary_of(ledger, card.name);
  std::string html = fmt::format(
      "<section class=\"card\"><h3>{} <small>{}</small></h3><p>{} of its rows hold, {} fail, {} say nothing</p>",
      escaped(card.name), escaped(card.version), summary.hold, summary.fail, summary.silent);
  html += grades(summary);
  if (summary.most_wrong != nullptr) {
    html += fmt::format("<p>Largest error: {:.3g} {} ({})</p>", summary.most_wrong->largest_error,
                        escaped(summary.most_wrong->unit), escaped(summary.most_wrong->property));
  }
  return html + fmt::format("<p class=\"soft\">{}</p>", escaped(card.about)) + deviations(card) + silences(summary) +
         "</section>";
}

// ---- failing rows ----

std::string definition(const std::string& term, const std::string& html) {
  return html.empty() ? "" : fmt::format("<dt>{}</dt><dd>{}</dd>", term, html);
}

std::string clause_words(const properties::Property& property) {
  std::string words;
  for (const std::string& id : property.clauses) {
    const properties::Clause& clause = properties::clause(id);
    words += fmt::format("<b>{}</b> {} ", escaped(clause.id), escaped(clause.says));
  }
  return words;
}

std::string about_the_case(const Row& row) {
  if (!row.smallest_case) return "";
  const oracle::Size size = oracle::size_of(row.smallest_case->scene);
  return definition("scene", fmt::format("{}; drawn as {} {} with {}", text_of(size), escaped(row.smallest->family),
                                         row.smallest->index, text_of(row.size_found))) +
         definition("note", escaped(row.smallest_case->note)) +
         definition("replay",
                    fmt::format("<code>touchstone replay {0}</code> <a href=\"{0}\">file</a>", escaped(row.case_file)));
}

std::string facts(const Row& row, const properties::Property& property) {
  const oracle::Finding& finding = shown_finding(row);
  std::string html;
  for (const auto& [label, words] : lines_of(finding)) html += definition(label, shown(words));
  html += definition("proof", shown(finding.certificate));
  html += definition("clause", clause_words(property));
  return html + about_the_case(row);
}

std::string failing_row(const Row& row) {
  const properties::Property& property = properties::find(row.property);
  const std::string drawing = row.smallest_case ? picture(row.smallest_case->scene) : "";
  return fmt::format(
      "<details class=\"row\" id=\"{}\"><summary>{}<b>{}</b> <span class=\"soft\">{}, {} of {}</span></summary>"
      "<p class=\"soft\">Must hold: {}.</p><div class=\"{}\">{}<dl>{}</dl></div></details>",
      anchor(row), badge(*row.grade()), escaped(row.property), escaped(oracle::name_of(shown_finding(row).defect)),
      row.fails + row.breaks, row.answered(), escaped(property.says), drawing.empty() ? "plain" : "drawn", drawing,
      facts(row, property));
}

std::string failures_of(const Ledger& ledger, const oracle::Card& card) {
  std::string rows;
  int count = 0;
  for (const Row& row : ledger.rows) {
    if (row.subject != card.name || !row.failing()) continue;
    rows += failing_row(row);
    ++count;
  }
  return fmt::format("<section><h3>{}: {}</h3>{}</section>", escaped(card.name),
                     count == 0 ? "nothing fails" : plural(count, "failing row"), rows);
}

// ---- at a glance ----

/// What shows an engine's fault best: a pair's distance or depth, wrong against the truth, badly, in few vertices.
const Row* plainest_failure(const Ledger& ledger, const std::string& subject) {
  const auto rank = [](const Row& row) {
    const std::string& stem = properties::find(row.property).stem;
    const oracle::Size size = oracle::size_of(row.smallest_case->scene);
    const oracle::Finding& finding = shown_finding(row);
    return std::tuple(stem != "distance" && stem != "penetration", finding.observed.empty() || finding.expected.empty(),
                      -static_cast<int>(*row.grade()), size.vertices_per_body_max + size.significant_bits_max);
  };
  const Row* best = nullptr;
  for (const Row& row : ledger.rows) {
    if (row.subject != subject || !row.smallest_case) continue;
    if (best == nullptr || rank(row) < rank(*best)) best = &row;
  }
  return best;
}

std::string glance(const Row& row) {
  const oracle::Finding& finding = shown_finding(row);
  std::string facts;
  for (const auto& [label, words] : {std::pair("it says", finding.observed), std::pair("truth", finding.expected),
                                     std::pair("because", finding.why)}) {
    facts += definition(label, shown(words));
  }
  return fmt::format(
      "<section class=\"card\"><h3>{}{}</h3><p class=\"soft\">must hold: {}</p>{}<dl>{}</dl><p><a "
      "href=\"#{}\">{}</a></p>"
      "</section>",
      badge(*row.grade()), escaped(row.subject), escaped(properties::find(row.property).says),
      picture(row.smallest_case->scene), facts, anchor(row), escaped(row.property));
}

std::string gallery(const Ledger& ledger) {
  std::string cards;
  for (const oracle::Card& card : ledger.subjects) {
    if (const Row* row = plainest_failure(ledger, card.name)) cards += glance(*row);
  }
  if (cards.empty()) return "<p>Nothing fails.</p>";
  return "<p>One failing scene of each engine, cut down to the smallest that still fails. Body A is drawn solid, body "
         "B dashed, "
         "the exact closest points as dots; a ring marks a body too small to see.</p><div class=\"cards\">" +
         cards + "</div>";
}

// ---- what was asked ----

std::string about_meshes(const Ledger& ledger) {
  if (ledger.mesh_count == 0) {
    return "<p><b>No real meshes:</b> " +
           escaped(ledger.meshes_absent.empty() ? "none were asked for" : ledger.meshes_absent) + ".</p>";
  }
  std::vector<std::string> kinds;
  for (const auto& [family, count] : ledger.mesh_scenes) kinds.push_back(fmt::format("{} {}", count, family));
  return fmt::format("<p>Real input: the convex hulls of {} robot meshes, in {} scenes ({}).</p>", ledger.mesh_count,
                     total(ledger.mesh_scenes), escaped(fmt::format("{}", fmt::join(kinds, ", "))));
}

std::string about_classes(const Ledger& ledger) {
  std::string html = ledger.empty_classes.empty()
                         ? "<p>Every kind of case that a stem needs was met.</p>"
                         : fmt::format("<p><b>Kinds of case that were not met:</b> {}.</p>",
                                       escaped(fmt::format("{}", fmt::join(ledger.empty_classes, "; "))));
  html += "<details><summary>Scenes of each kind</summary><div class=\"scroll\"><table><tbody>";
  for (const auto& [stem, classes] : ledger.classes) {
    html += fmt::format("<tr class=\"stem\"><th scope=\"rowgroup\">{}</th><td></td></tr>", escaped(stem));
    for (const auto& [name, count] : classes) {
      html += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>", escaped(name), count);
    }
  }
  return html + "</tbody></table></div></details>";
}

long questions_answered(const Ledger& ledger) {
  long sum = 0;
  for (const Row& row : ledger.rows) sum += row.answered();
  return sum;
}

std::string lead(const Ledger& ledger) {
  return fmt::format(
      "<p class=\"lead\">{} were asked about {}, hard on purpose, whose exact answers are known: {} answers judged. "
      "<span class=\"soft\">Touchstone {}, seed {}, effort {}.</span></p>",
      plural(static_cast<long>(ledger.subjects.size()), "subject"), plural(total(ledger.scenes), "scene"),
      questions_answered(ledger), version, ledger.seed, escaped(ledger.effort));
}

constexpr const char* limitations = R"html(<ul>
<li>Scenes are drawn near-degenerate on purpose: the share of failures says nothing about how often an engine is wrong in use.</li>
<li>Engines are asked raw queries, with margin 0 where they offer it; in use they add margins that hide some of this.</li>
<li>An engine gets the unit quaternion in its own precision. That rounding is part of what is allowed, not of the engine’s error.</li>
<li>The cut-down scene shows one defect of a row; others may hide behind it.</li>
<li>After three hangs among some 24 scenes an engine is not asked about the rest of them; “not asked” counts those.</li>
<li>Penetration depth is judged for convex bodies only.</li></ul>)html";

std::string head() {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width,initial-scale=1\"><link rel=\"icon\" href=\"data:,\"><title>Touchstone "
      "report</title><style>{}</style></head>",
      report_style);
}

std::string header(const Ledger& ledger) {
  return fmt::format(
      "<header><h1>Who is wrong, by how much, on what</h1>{}{}<nav aria-label=\"Contents\"><a href=\"#glance\">At a "
      "glance</a>"
      "<a href=\"#table\">Table</a><a href=\"#subjects\">Subjects</a><a href=\"#failures\">Failing rows</a>"
      "<a href=\"#asked\">What was asked</a><a href=\"#limits\">Limits</a></nav></header>",
      lead(ledger),
      ledger.interrupted ? "<p class=\"partial\"><b>Interrupted: this report is partial.</b> What was not asked is not "
                           "counted.</p>"
                         : "");
}

}  // namespace

std::string report_html(const Ledger& ledger) {
  std::string html = head() + "<body>" + header(ledger) + "<main>";
  html += "<h2 id=\"glance\">At a glance</h2>" + gallery(ledger);
  html += "<h2 id=\"table\">Properties and subjects</h2>" + std::string(legend) + matrix(ledger);
  html += "<h2 id=\"subjects\">Subjects</h2><div class=\"cards\">";
  for (const oracle::Card& card : ledger.subjects) html += subject_card(ledger, card);
  html += "</div><h2 id=\"failures\">Failing rows</h2><p>Each opens to its smallest failing scene.</p>";
  for (const oracle::Card& card : ledger.subjects) html += failures_of(ledger, card);
  html += "<h2 id=\"asked\">What was asked</h2>" + about_meshes(ledger) + about_classes(ledger);
  html += "<h2 id=\"limits\">Limits</h2>" + std::string(limitations);
  return html + "</main></body></html>\n";
}

}  // namespace touchstone::app
