#include <fmt/format.h>

#include <string>

#include "app/report/page/page.h"
#include "app/report/xml.h"
#include "app/trial/row.h"

namespace touchstone::app::page {
namespace {

std::string parts_of(const std::string& query, const LeftOut& left_out) {
  std::string html = fmt::format("<tr class=\"query\"><th scope=\"rowgroup\">{}</th><td>{} planned</td><td></td></tr>",
                                 query, plural(left_out.planned, "scene"));
  for (const auto& [what, part] : left_out.parts) {
    html += fmt::format("<tr><th scope=\"row\">{}</th><td>{}, {}</td><td>{}</td></tr>", escaped(what),
                        plural(part.scenes, "scene"), percent(part.scenes, left_out.planned), escaped(part.why));
  }
  return html;
}

}  // namespace

std::string left_out(const Ledger& ledger) {
  std::string rows;
  for (const ResultMatrix::Properties& properties : ledger.results.by_query()) {
    const std::string& query = properties.front()->query;
    const auto profile = ledger.profiles.find(query);
    if (profile != ledger.profiles.end() && profile->second.left_out.planned > 0) {
      rows += parts_of(query, profile->second.left_out);
    }
  }
  if (rows.empty()) return "<p>No scene of this report has a plan.</p>";
  return "<p>Parts of <code>fast</code> that a scene of this report does not need, so that they are left out; the last "
         "column says why, for the first such scene. <code>touchstone plan SCENE</code> prints it for one "
         "scene.</p>" +
         scrolling("What is left out",
                   "<table class=\"left-out\"><thead><tr><th scope=\"col\">left out</th><th scope=\"col\">on</th><th "
                   "scope=\"col\">why, once</th></tr></thead><tbody>" +
                       rows + "</tbody></table>");
}

}  // namespace touchstone::app::page
