#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "app/report/page/page.h"
#include "app/report/xml.h"

namespace touchstone::app::page {
namespace {

long total(const std::map<std::string, long>& counts) {
  long sum = 0;
  for (const auto& [name, count] : counts) sum += count;
  return sum;
}

std::string about_meshes(const Ledger& ledger) {
  if (ledger.meshes.count == 0) {
    return "<p><b>No real meshes:</b> " +
           escaped(ledger.meshes.absent.empty() ? "none were asked for" : ledger.meshes.absent) + ".</p>";
  }
  std::vector<std::string> kinds;
  for (const auto& [family, count] : ledger.meshes.scenes) kinds.push_back(fmt::format("{} {}", count, family));
  const std::string left_out = ledger.meshes.left_out == 0
                                   ? ""
                                   : fmt::format(" Left out: {} that are flat or no meshes.", ledger.meshes.left_out);
  return fmt::format("<p>Real input: the convex hulls of {} robot meshes, in {} scenes ({}).{}</p>",
                     ledger.meshes.count, total(ledger.meshes.scenes),
                     escaped(fmt::format("{}", fmt::join(kinds, ", "))), left_out);
}

std::string about_classes(const Ledger& ledger) {
  std::string html = ledger.empty_classes.empty()
                         ? "<p>There were scenes of every class.</p>"
                         : fmt::format("<p><b>Classes without any scene:</b> {}.</p>",
                                       escaped(fmt::format("{}", fmt::join(ledger.empty_classes, "; "))));
  std::string table = "<table><tbody>";
  for (const auto& [query, classes] : ledger.classes) {
    table += fmt::format("<tr class=\"query\"><th scope=\"rowgroup\">{}</th><td></td></tr>", escaped(query));
    for (const auto& [name, count] : classes) {
      table += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>", escaped(name), count);
    }
  }
  return html + "<details><summary>Scenes of each class</summary>" +
         scrolling("Scenes of each class", table + "</tbody></table>") + "</details>";
}

}  // namespace

std::string what_was_asked(const Ledger& ledger) { return about_meshes(ledger) + about_classes(ledger); }

}  // namespace touchstone::app::page
