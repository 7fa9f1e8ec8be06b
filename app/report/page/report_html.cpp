#include "app/report/page/report_html.h"

#include <fmt/format.h>

#include "app/report/page/page.h"
#include "app/report/page/script.h"
#include "app/report/page/style.h"
#include "app/report/page/turn_script.h"
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
<li>After three hangs among 24 scenes, or a fortieth of a query’s, an engine is not asked about the rest of the query’s scenes; “not asked” counts those.</li>
<li>Penetration depth is judged for convex bodies only.</li></ul>)html";

std::string head() {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width,initial-scale=1\"><link rel=\"icon\" href=\"data:,\"><title>Touchstone "
      "report</title><style>{}</style></head>",
      report_style);
}

constexpr const char* contents = R"html(<nav aria-label="Contents"><a href="#matrix">Subjects and queries</a>
<a href="#plainest">One failing scene of each</a><a href="#table">Properties</a><a href="#failures">Failing rows</a>
<a href="#errors">Errors</a><a href="#speed">Error against CPU time</a><a href="#atlas">Where they fail</a>
<a href="#subjects">Subjects</a><a href="#left-out">What fast leaves out</a><a href="#asked">What was asked</a>
<a href="#limits">Limits</a></nav>)html";

/// Shown by the script alone.
constexpr const char* filter = R"html(<form id="filter" role="search" hidden><label>Subjects <input name="subjects"
type="search" placeholder="bullet fcl" autocomplete="off"></label> <label>Properties <input name="properties" type="search"
placeholder="distance.value" autocomplete="off"></label></form>)html";

std::string header(const Ledger& ledger) {
  return fmt::format(
      "<header><h1>Which engines are wrong, by how much, on which scenes</h1>{}{}{}{}</header>", lead(ledger),
      ledger.interrupted ? "<p class=\"partial\"><b>Interrupted: this report is partial.</b> What was not asked is not "
                           "counted.</p>"
                         : "",
      contents, filter);
}

}  // namespace

std::string report_html(const Ledger& ledger) {
  const auto section = [](const char* id, const char* heading, const std::string& html) {
    return fmt::format("<section aria-labelledby=\"{0}\"><h2 id=\"{0}\">{1}</h2>{2}</section>", id, heading, html);
  };
  return head() + "<body>" + header(ledger) + "<main>" +                                 //
         section("matrix", "Subjects and queries", page::matrix(ledger)) +               //
         section("plainest", "One failing scene of each", page::gallery(ledger)) +       //
         section("table", "Properties", page::tables(ledger)) +                          //
         section("failures", "Failing rows", page::failures(ledger)) +                   //
         section("errors", "Errors", page::errors(ledger)) +                             //
         section("speed", "Error against CPU time", page::speed(ledger)) +               //
         section("atlas", "Where they fail", page::atlas(ledger)) +                      //
         section("subjects", "Subjects", page::subjects(ledger)) +                       //
         section("left-out", "What fast leaves out", page::left_out(ledger)) +           //
         section("asked", "What was asked", page::what_was_asked(ledger)) +              //
         section("limits", "Limits", limitations) + "</main><script>" + report_script +  //
         turn_script + "</script></body></html>\n";
}

}  // namespace touchstone::app
