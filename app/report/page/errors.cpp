#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/report/page/page.h"
#include "app/report/xml.h"

namespace touchstone::app::page {
namespace {

/// The columns: errors of at most 2^edge and above the previous edge. Fine near the size of rounding, coarse beyond.
constexpr std::array edges = {-4, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 15, 20, 30, 40, 50};

std::string power_of_two(int k) {
  return -2 <= k && k <= 10 ? fmt::format("{:g}", k < 0 ? 1.0 / (1 << -k) : 1 << k) : fmt::format("2<sup>{}</sup>", k);
}

/// Errors of 0, one column for each edge, and larger errors.
using Columns = std::array<long, edges.size() + 2>;

Columns columns_of(const ErrorHistogram& errors) {
  Columns columns{};
  columns.front() = errors.exact;
  columns.back() = errors.infinite;
  for (const auto& [power, count] : errors.powers) {
    const auto edge = std::ranges::lower_bound(edges, power);
    columns[static_cast<std::size_t>(edge - edges.begin()) + 1] += count;
  }
  return columns;
}

std::string heading(std::size_t column) {
  if (column == 0) return "0";
  return column > edges.size() ? "more" : "≤ " + power_of_two(edges[column - 1]);
}

std::string row_of(const Row& row, std::size_t first, std::size_t last) {
  const Columns columns = columns_of(row.errors);
  std::string html = fmt::format("<tr><th scope=\"row\">{}</th>", escaped(row.subject->card.name));
  for (std::size_t c = first; c <= last; ++c) {
    const double share = static_cast<double>(columns[c]) / static_cast<double>(row.errors.total());
    html += columns[c] == 0 ? "<td></td>"
                            : fmt::format("<td class=\"share\" style=\"--share:{:.2f}\">{}</td>", share, columns[c]);
  }
  return html + fmt::format("<td>{:.4g}</td></tr>", row.errors.largest);
}

std::string distribution(const properties::Property& property, const std::vector<const Row*>& rows) {
  Columns all{};
  for (const Row* row : rows) {
    const Columns columns = columns_of(row->errors);
    for (std::size_t c = 0; c < all.size(); ++c) all[c] += columns[c];
  }
  const auto used = [](long count) { return count > 0; };
  const auto first = static_cast<std::size_t>(std::ranges::find_if(all, used) - all.begin());
  std::size_t last = all.size() - 1;
  while (last > first && all[last] == 0) --last;
  std::string table = "<table><thead><tr><th scope=\"col\">subject</th>";
  for (std::size_t c = first; c <= last; ++c) table += fmt::format("<th scope=\"col\">{}</th>", heading(c));
  table += "<th scope=\"col\">largest</th></tr></thead><tbody>";
  for (const Row* row : rows) table += row_of(*row, first, last);
  return fmt::format("<details><summary>{}, in {}: {}</summary>{}</details>", escaped(property.id),
                     escaped(rows.front()->errors.unit), escaped(property.says),
                     scrolling("Errors of " + property.id, table + "</tbody></table>"));
}

}  // namespace

std::string errors(const Ledger& ledger) {
  std::string html =
      "<p class=\"soft\">How many answers were off by how much, the right ones too. A cell counts the errors up to its "
      "head, above the cell before.</p>";
  for (const properties::Property* property : ledger.results.tested_properties()) {
    std::vector<const Row*> measured;
    for (const Row& row : ledger.results.of(*property)) {
      if (row.errors.total() > 0) measured.push_back(&row);
    }
    if (!measured.empty()) html += distribution(*property, measured);
  }
  return html;
}

}  // namespace touchstone::app::page
