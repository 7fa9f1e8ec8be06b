#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/benchmarks/work_precision.h"
#include "app/report/chart.h"
#include "app/report/xml.h"

namespace touchstone::app {
namespace {

constexpr double panel_width = 520;
constexpr double panel_height = 400;
constexpr double left = 64;
constexpr double right = 170;  // for the labels of the lines
constexpr double top = 34;
constexpr double bottom = 62;  // for the axis and the row of exact answers

struct Line {
  std::string name;
  std::vector<const WorkPrecision*> points;
  double label_y = 0;
};

bool drawable(const WorkPrecision& row) { return row.ns && row.worst_error && std::isfinite(*row.worst_error); }

LogAxes axes_of(const std::vector<WorkPrecision>& rows) {
  LogAxes axes{left, panel_width - right, top, panel_height - bottom};
  for (const WorkPrecision& row : rows) {
    if (!drawable(row)) continue;
    axes.include_x(*row.ns);
    if (*row.worst_error > 0) axes.include_y(*row.worst_error);
  }
  axes.close();
  return axes;
}

std::vector<Line> curves_of(const std::vector<WorkPrecision>& rows, const std::string& workload) {
  std::vector<Line> lines;
  for (const WorkPrecision& row : rows) {
    if (row.workload != workload || !drawable(row)) continue;
    auto line = std::ranges::find_if(lines, [&](const Line& l) { return l.name == row.name; });
    if (line == lines.end()) line = lines.insert(lines.end(), {row.name, {}, 0});
    line->points.push_back(&row);
  }
  return lines;
}

/// Puts each name at the height of the end of its line.
void place_names(std::vector<Line>& lines, const LogAxes& axes) {
  std::vector<double> wanted;
  for (const Line& line : lines) wanted.push_back(axes.y(*line.points.back()->worst_error));
  const std::vector<double> heights = apart(wanted, axes.top, panel_height);
  for (std::size_t i = 0; i < lines.size(); ++i) lines[i].label_y = heights[i];
}

std::string grid(const LogAxes& axes) {
  return axes.rows() + axes.columns(32) +
         fmt::format("<text x='{}' y='{:.1f}' text-anchor='end'>exact</text>\n", left - 6, axes.y(0) + 4);
}

/// The class in the style sheet: one for ours, one per library.
std::string style_of(const Line& line) {
  if (line.points.front()->whose == "ours") return "default";
  std::string library = line.name.substr(0, line.name.find_first_of(". "));
  std::ranges::transform(library, library.begin(), [](char c) { return 'A' <= c && c <= 'Z' ? c - 'A' + 'a' : c; });
  return library;
}

std::string drawn(const Line& line, const LogAxes& axes) {
  std::string path, dots;
  for (const WorkPrecision* point : line.points) {
    const double x = axes.x(*point->ns), y = axes.y(*point->worst_error);
    path += fmt::format("{:.1f},{:.1f} ", x, y);
    dots += fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='2.6'><title>{}, {}: {:.4g} ns, {:.3g}</title></circle>", x,
                        y, escaped(line.name), escaped(point->size), *point->ns, *point->worst_error);
  }
  const WorkPrecision& last = *line.points.back();
  const double label_x = panel_width - right + 12;
  return fmt::format(
      "<g class='{}'><polyline points='{}'/>{}<line class='lead' x1='{:.1f}' y1='{:.1f}' x2='{:.1f}' y2='{:.1f}'/>"
      "<text x='{:.1f}' y='{:.1f}'>{}</text></g>\n",
      style_of(line), path, dots, axes.x(*last.ns), axes.y(*last.worst_error), label_x - 2, line.label_y, label_x,
      line.label_y + 4, escaped(line.name));
}

std::string panel(const std::vector<WorkPrecision>& rows, const std::string& workload, const LogAxes& axes,
                  const WorkPrecisionWords& words) {
  std::vector<Line> lines = curves_of(rows, workload);
  place_names(lines, axes);
  std::string svg = fmt::format("<text class='title' x='{}' y='20'>{}</text>\n", left, escaped(workload)) + grid(axes);
  for (const Line& line : lines) svg += drawn(line, axes);
  const double middle = (top + panel_height - bottom) / 2;
  return svg + fmt::format(
                   "<text x='{}' y='{}' text-anchor='middle'>ns a query; a point for each of the {}</text>\n"
                   "<text x='14' y='{}' text-anchor='middle' transform='rotate(-90 14 {})'>worst error, {}</text>\n",
                   (left + panel_width - right) / 2, panel_height - 8, escaped(words.size), middle, middle,
                   escaped(words.error));
}

constexpr const char* style = R"(<style>
svg { background: #ffffff; color: #1f2937; font: 11px sans-serif }
text { fill: currentColor } .title { font-size: 15px; font-weight: bold }
polyline { fill: none; stroke: currentColor; stroke-width: 1.3 } circle { fill: currentColor }
.grid { stroke: currentColor; stroke-opacity: .16 } .lead { stroke: currentColor; stroke-width: .6; stroke-opacity: .5 }
g { color: #64748b } g.panel { color: inherit }
g.default { color: #2563eb } g.default text { font-weight: bold } g.default polyline { stroke-width: 3 }
g.bullet { color: #d97706 } g.fcl { color: #16a34a } g.libccd { color: #db2777 } g.ode { color: #8b5cf6 }
@media (prefers-color-scheme: dark) { svg { background: #111827; color: #e5e7eb } g { color: #94a3b8 }
g.default { color: #60a5fa } }
</style>
)";

}  // namespace

std::string work_precision_plot(const std::vector<WorkPrecision>& rows, const WorkPrecisionWords& words) {
  std::vector<std::string> workloads;
  for (const WorkPrecision& row : rows) {
    if (drawable(row) && std::ranges::count(workloads, row.workload) == 0) workloads.push_back(row.workload);
  }
  const LogAxes axes = axes_of(rows);
  const std::size_t columns = std::clamp<std::size_t>(workloads.size(), 1, 2);
  const std::size_t height = (workloads.size() + columns - 1) / columns;
  std::string svg =
      fmt::format("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {} {}'>\n{}",
                  panel_width * static_cast<double>(columns), panel_height * static_cast<double>(height), style);
  for (std::size_t i = 0; i < workloads.size(); ++i) {
    svg += fmt::format("<g class='panel' transform='translate({} {})'>\n{}</g>\n",
                       panel_width * static_cast<double>(i % columns), panel_height * static_cast<double>(i / columns),
                       panel(rows, workloads[i], axes, words));
  }
  return svg + "</svg>\n";
}

}  // namespace touchstone::app
