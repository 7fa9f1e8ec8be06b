#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "app/report/page/page.h"
#include "app/report/xml.h"

namespace touchstone::app::page {
namespace {

constexpr std::size_t least_classes = 2;  ///< in which scenes were: of one class there is nothing to compare

/// The cells of one query and axis, by subject and class.
struct AxisTable {
  const Ledger& ledger;
  const QueryProfile& profile;
  int axis = 0;

  const AtlasAxis& about() const { return atlas_axes()[static_cast<std::size_t>(axis)]; }

  const AtlasCell* find(const TestedSubject& subject, int k) const {
    const Atlas& atlas = profile.atlas[subject.index];
    const auto found = atlas.find({axis, k});
    return found == atlas.end() ? nullptr : &found->second;
  }

  /// Those in which any subject answered.
  std::vector<int> classes() const {
    std::set<int> used;
    for (const Atlas& atlas : profile.atlas) {
      for (const auto& [place, cell] : atlas) {
        if (place.first == axis) used.insert(place.second);
      }
    }
    return {used.begin(), used.end()};
  }
};

/// Empty where no answer is off, or has a size of its error.
std::string excess_of(const AtlasCell& cell) {
  if (!(cell.excess > 0)) return "";
  if (std::isinf(cell.excess)) return "<small>∞</small>";
  return cell.excess < 0.01 ? "<small>&lt;0.01×</small>" : fmt::format("<small>{:.2g}×</small>", cell.excess);
}

/// "0", "≤ 0.1", "> 1e9": the classes of an axis follow each other, so the upper edge names one.
std::string head_of(const AtlasAxis& axis, int k) {
  const Interval bounds = class_bounds(axis, k);
  if (std::isinf(bounds.hi)) return fmt::format("&gt; {:g}", bounds.lo);
  return bounds.hi == 0 ? "0" : fmt::format("≤ {:g}", bounds.hi);
}

/// Shaded in tenths, so that a cell takes few bytes.
int shade_of(const AtlasCell& cell) {
  if (cell.failing == 0) return 0;
  return std::clamp(static_cast<int>(10 * cell.failing / cell.scenes), 1, 9);
}

std::string class_words(const AtlasCell& cell, DomainSide side) {
  const std::string edge = side == DomainSide::outside ? " out" : side == DomainSide::across ? " rim" : "";
  return fmt::format("h{}{}", shade_of(cell), edge);
}

std::string atlas_cell(const AtlasCell& cell, DomainSide side) {
  const std::string words = class_words(cell, side);
  const std::string broken = cell.broken > 0 ? fmt::format("<b>{} broken</b>", cell.broken) : "";
  return fmt::format("<td class={1}{0}{1}>{2} of {3}{4}{5}</td>", words,
                     words.find(' ') == std::string::npos ? "" : "\"", cell.failing, cell.scenes, excess_of(cell),
                     broken);
}

std::string atlas_row(const AxisTable& table, const std::vector<int>& classes, const TestedSubject& subject) {
  std::string cells;
  bool any = false;
  for (const int k : classes) {
    const DomainSide side = side_of(table.about(), k, subject.card.domain);
    const AtlasCell* cell = table.find(subject, k);
    any |= cell != nullptr;
    cells += cell != nullptr               ? atlas_cell(*cell, side)
             : side == DomainSide::outside ? "<td class=out>"
             : side == DomainSide::across  ? "<td class=rim>"
                                           : "<td>";
  }
  if (!any) return "";
  return fmt::format("<tr data-subject=\"{0}\"><th scope=\"row\">{0}</th>{1}</tr>\n", escaped(subject.card.name),
                     cells);
}

std::string axis_table(const AxisTable& table, const std::string& query) {
  const std::vector<int> classes = table.classes();
  if (classes.size() < least_classes) return "";
  const AtlasAxis& axis = table.about();
  const std::string unit = axis.unit == "1" ? "" : ", " + axis.unit;
  std::string html = fmt::format("<table class=\"atlas\"><thead><tr><th scope=\"col\">{}{}</th>", axis.name, unit);
  for (const int k : classes) html += fmt::format("<th scope=\"col\">{}</th>", head_of(axis, k));
  html += "</tr></thead><tbody>";
  for (const TestedSubject& subject : table.ledger.subjects) html += atlas_row(table, classes, subject);
  return fmt::format("<details><summary>{}{}: {}</summary>{}</details>", axis.name, unit, escaped(axis.says),
                     scrolling(query + " by " + axis.name, html + "</tbody></table>"));
}

std::string query_atlas(const Ledger& ledger, const std::string& query, const QueryProfile& profile) {
  std::string html;
  for (int axis = 0; axis < static_cast<int>(atlas_axes().size()); ++axis) {
    html += axis_table({ledger, profile, axis}, query);
  }
  if (html.empty()) return "";
  return fmt::format("<section id=\"atlas.{0}\"><h3>{0}</h3>{1}</section>", query, html);
}

}  // namespace

std::string atlas(const Ledger& ledger) {
  std::string html =
      "<p>Each query’s scenes by one size at a time, in classes named by their upper edge: on how many scenes any "
      "property fails, of those that the subject answered; below, the largest error of any answer over what rounding "
      "explains (1× and less: within it). The stronger the colour, the larger the share. Classes beyond the <b>domain "
      "that a subject declares</b> are hatched, and a class that its limit divides has a dashed edge. <span "
      "class=\"soft\">A "
      "scene that is extreme in one size is often so in others: a column shows where a subject fails, not why. For "
      "programs: <a href=\"atlas.csv\">atlas.csv</a>, by the command of this report.</span></p>";
  for (const ResultMatrix::Properties& properties : ledger.results.by_query()) {
    const std::string& query = properties.front()->query;
    const auto profile = ledger.profiles.find(query);
    if (profile != ledger.profiles.end()) html += query_atlas(ledger, query, profile->second);
  }
  return html;
}

}  // namespace touchstone::app::page
