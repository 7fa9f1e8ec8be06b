#include "app/benchmarks/bench_plot.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/report/chart.h"
#include "app/report/xml.h"

namespace touchstone::app {
namespace {

constexpr double panel_width = 470;
constexpr double panel_height = 400;
constexpr double left_margin = 56;
constexpr double right_margin = 160;  // for the labels of the lines
constexpr double top_margin = 34;
constexpr double bottom_margin = 42;

using Points = std::vector<std::pair<double, double>>;

struct Line {
  std::string name;
  bool peer = false;
  Points points;
  double label_y = 0;
};

LogAxes axes_of(const std::vector<BenchRow>& rows) {
  LogAxes axes{left_margin, panel_width - right_margin, top_margin, panel_height - bottom_margin};
  for (const BenchRow& row : rows) {
    if (!row.ns) continue;
    axes.include_x_as_edge(static_cast<double>(row.bodies));
    axes.include_y(*row.ns);
  }
  axes.close();
  return axes;
}

/// The class in the style sheet below: one per library.
std::string style_of(const Line& line) {
  if (line.peer) return line.name.substr(0, line.name.find('.'));
  return line.name == "wrapped_grid" ? "default" : "ours";
}

std::vector<Line> curves_of(const std::vector<BenchRow>& rows, const std::string& workload) {
  std::vector<Line> lines;
  for (const BenchRow& row : rows) {
    if (row.workload != workload || !row.ns) continue;
    auto line = std::ranges::find_if(lines, [&](const Line& l) { return l.name == row.name; });
    if (line == lines.end()) line = lines.insert(lines.end(), {row.name, row.peer, {}, 0});
    line->points.emplace_back(static_cast<double>(row.bodies), *row.ns);
  }
  return lines;
}

/// Puts each name at the end of its line.
void place_names(std::vector<Line>& lines, const LogAxes& axes) {
  std::vector<double> wanted;
  for (const Line& line : lines) wanted.push_back(axes.y(line.points.back().second));
  const std::vector<double> heights = apart(wanted, axes.top, axes.bottom);
  for (std::size_t i = 0; i < lines.size(); ++i) lines[i].label_y = heights[i];
}

std::string grid(const LogAxes& axes, const std::vector<BenchRow>& rows) {
  std::string svg = axes.rows();
  std::vector<std::size_t> sizes;
  for (const BenchRow& row : rows) {
    if (row.ns && std::ranges::count(sizes, row.bodies) == 0) sizes.push_back(row.bodies);
  }
  for (const std::size_t n : sizes) svg += axes.column(static_cast<double>(n), std::to_string(n), 16);
  return svg;
}

std::string drawn(const Line& line, const LogAxes& axes) {
  const std::string style = style_of(line);
  std::string path;
  std::string dots;
  for (const auto& [n, ns] : line.points) {
    path += fmt::format("{:.1f},{:.1f} ", axes.x(n), axes.y(ns));
    dots += fmt::format("<circle class='{}' cx='{:.1f}' cy='{:.1f}' r='2.2'/>", style, axes.x(n), axes.y(ns));
  }
  const auto& [last_n, last_ns] = line.points.back();
  const double label_x = panel_width - right_margin + 12;
  return fmt::format(
      "<polyline class='{0}' points='{1}'/>{2}<line class='lead {0}' x1='{3:.1f}' y1='{4:.1f}' "
      "x2='{5:.1f}' y2='{6:.1f}'/><text class='{0}' x='{7:.1f}' y='{8:.1f}'>{9}</text>\n",
      style, path, dots, axes.x(last_n), axes.y(last_ns), label_x - 2, line.label_y, label_x, line.label_y + 4,
      escaped(line.name));
}

std::string panel(const std::vector<BenchRow>& rows, const std::string& workload, const LogAxes& axes) {
  std::vector<Line> lines = curves_of(rows, workload);
  place_names(lines, axes);
  std::string svg = fmt::format("<text class='title' x='{}' y='20'>{}</text>\n", left_margin, escaped(workload));
  svg += grid(axes, rows);
  for (const Line& line : lines) svg += drawn(line, axes);
  svg += fmt::format("<text x='{}' y='{}' text-anchor='middle'>bodies</text>\n",
                     (left_margin + panel_width - right_margin) / 2, panel_height - 6);
  const double middle = (top_margin + panel_height - bottom_margin) / 2;
  svg += fmt::format(
      "<text x='14' y='{0}' text-anchor='middle' transform='rotate(-90 14 {0})'>ns a body and "
      "frame</text>\n",
      middle);
  return svg;
}

constexpr const char* style = R"(<style>
svg { background: #ffffff; color: #1f2937; font: 11px sans-serif }
text { fill: currentColor } .title { font-size: 15px; font-weight: bold }
polyline { fill: none; stroke-width: 1.3 } .grid { stroke: currentColor; stroke-opacity: .16 }
line.lead { stroke-width: .6; stroke-opacity: .6 }
.default { stroke: #2563eb } text.default { fill: #2563eb; stroke: none; font-weight: bold } circle.default { fill: #2563eb }
polyline.default { stroke-width: 3 }
.ours { stroke: #64748b } text.ours { fill: #64748b; stroke: none } circle.ours { fill: #64748b }
.bullet { stroke: #d97706 } text.bullet { fill: #d97706; stroke: none } circle.bullet { fill: #d97706 }
.fcl { stroke: #16a34a } text.fcl { fill: #16a34a; stroke: none } circle.fcl { fill: #16a34a }
.ode { stroke: #db2777 } text.ode { fill: #db2777; stroke: none } circle.ode { fill: #db2777 }
.cgal { stroke: #8b5cf6 } text.cgal { fill: #8b5cf6; stroke: none } circle.cgal { fill: #8b5cf6 }
@media (prefers-color-scheme: dark) {
svg { background: #111827; color: #e5e7eb }
.default { stroke: #60a5fa } text.default, circle.default { fill: #60a5fa }
.ours { stroke: #94a3b8 } text.ours, circle.ours { fill: #94a3b8 } }
</style>
)";

}  // namespace

std::string bench_plot(const std::vector<BenchRow>& rows) {
  std::vector<std::string> workloads;
  for (const BenchRow& row : rows) {
    if (row.ns && std::ranges::count(workloads, row.workload) == 0) workloads.push_back(row.workload);
  }
  const LogAxes axes = axes_of(rows);
  const std::size_t columns = std::min<std::size_t>(2, std::max<std::size_t>(1, workloads.size()));
  const std::size_t height = (workloads.size() + columns - 1) / columns;
  std::string svg =
      fmt::format("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {} {}'>\n{}",
                  panel_width * static_cast<double>(columns), panel_height * static_cast<double>(height), style);
  for (std::size_t i = 0; i < workloads.size(); ++i) {
    svg += fmt::format("<g transform='translate({} {})'>\n{}</g>\n", panel_width * static_cast<double>(i % columns),
                       panel_height * static_cast<double>(i / columns), panel(rows, workloads[i], axes));
  }
  return svg + "</svg>\n";
}

}  // namespace touchstone::app
