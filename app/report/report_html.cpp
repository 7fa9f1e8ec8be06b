#include "app/report/report_html.h"

#include <fmt/format.h>

#include "app/report/page.h"
#include "app/report/report_style.h"
#include "app/report/xml.h"
#include "app/system/version.h"

namespace touchstone::app {
namespace {

long scenes_asked(const Ledger& ledger) {
  long sum = 0;
  for (const auto& [query, count] : ledger.scenes) sum += count;
  return sum;
}

long questions_answered(const Ledger& ledger) {
  long sum = 0;
  for (const Row& row : ledger.results.all()) sum += row.answered();
  return sum;
}

std::string lead(const Ledger& ledger) {
  return fmt::format(
      "<p class=\"lead\">{} were asked about {}, hard on purpose, whose exact answers are known: {} answers judged. "
      "<span class=\"soft\">Touchstone {}, seed {}, effort {}.</span></p>",
      page::plural(static_cast<long>(ledger.subjects.size()), "subject"), page::plural(scenes_asked(ledger), "scene"),
      questions_answered(ledger), version, ledger.seed, escaped(ledger.effort));
}

constexpr const char* limitations = R"html(<ul>
<li>Scenes are drawn near-degenerate on purpose: the share of failures says nothing about how often an engine is wrong in use.</li>
<li>Engines are asked raw queries, with margin 0 where they offer it; in use they add margins that hide some of this.</li>
<li>An engine gets the unit quaternion in its own precision. That rounding is part of what is allowed, not of the engine’s error.</li>
<li>The cut-down scene shows one defect of a row; others may hide behind it.</li>
<li>After three hangs among some 24 scenes an engine is not asked about the rest of the query’s scenes; “not asked” counts those.</li>
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
      "<header><h1>Which engines are wrong, by how much, on which scenes</h1>{}{}<nav aria-label=\"Contents\"><a "
      "href=\"#glance\">At a "
      "glance</a>"
      "<a href=\"#table\">Table</a><a href=\"#subjects\">Subjects</a><a href=\"#errors\">Errors</a><a "
      "href=\"#failures\">Failing rows</a>"
      "<a href=\"#asked\">What was asked</a><a href=\"#limits\">Limits</a></nav></header>",
      lead(ledger),
      ledger.interrupted ? "<p class=\"partial\"><b>Interrupted: this report is partial.</b> What was not asked is not "
                           "counted.</p>"
                         : "");
}

}  // namespace

std::string report_html(const Ledger& ledger) {
  return head() + "<body>" + header(ledger) + "<main>" +                          //
         "<h2 id=\"glance\">At a glance</h2>" + page::gallery(ledger) +           //
         "<h2 id=\"table\">Properties and subjects</h2>" + page::table(ledger) +  //
         "<h2 id=\"subjects\">Subjects</h2>" + page::subjects(ledger) +           //
         "<h2 id=\"errors\">Errors</h2>" + page::errors(ledger) +                 //
         "<h2 id=\"failures\">Failing rows</h2>" + page::failures(ledger) +       //
         "<h2 id=\"asked\">What was asked</h2>" + page::what_was_asked(ledger) +  //
         "<h2 id=\"limits\">Limits</h2>" + limitations + "</main></body></html>\n";
}

}  // namespace touchstone::app
