#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/benchmarks/work_precision.h"
#include "app/report/xml.h"

namespace touchstone::app {
namespace {

constexpr double panel_width = 520;
constexpr double panel_height = 400;
constexpr double left = 64;
constexpr double right = 170;  // for the labels of the lines
constexpr double top = 34;
constexpr double bottom = 62;  // for the axis and the row of exact answers
constexpr double line_of_text = 12;

struct Line {
  std::string name;
  std::vector<const WorkPrecision*> points;
  double label_y = 0;
};

/// The ranges of both axes in decades, common to all panels.
struct Axes {
  double x0 = 1e300, x1 = -1e300, y0 = 1e300, y1 = -1e300;

  double x(double ns) const { return left + (std::log10(ns) - x0) / (x1 - x0) * (panel_width - left - right); }
  double y(double error) const {
    if (!(error > 0)) return panel_height - bottom + 16;
    return panel_height - bottom - (std::log10(error) - y0) / (y1 - y0) * (panel_height - top - bottom);
  }
};

bool drawable(const WorkPrecision& row) { return row.ns && row.worst_error && std::isfinite(*row.worst_error); }

Axes axes_of(const std::vector<WorkPrecision>& rows) {
  Axes axes;
  for (const WorkPrecision& row : rows) {
    if (!drawable(row)) continue;
    axes.x0 = std::min(axes.x0, std::floor(std::log10(*row.ns)));
    axes.x1 = std::max(axes.x1, std::ceil(std::log10(*row.ns) + 1e-9));
    if (!(*row.worst_error > 0)) continue;
    axes.y0 = std::min(axes.y0, std::floor(std::log10(*row.worst_error)));
    axes.y1 = std::max(axes.y1, std::ceil(std::log10(*row.worst_error) + 1e-9));
  }
  if (axes.y0 > axes.y1) axes.y0 = -1, axes.y1 = 1;  // no contestant has an error
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

/// Puts each label at the height of the end of its line. Overlapping labels are moved down.
void place_names(std::vector<Line>& lines, const Axes& axes) {
  for (Line& line : lines) line.label_y = axes.y(*line.points.back()->worst_error);
  std::ranges::sort(lines, {}, &Line::label_y);
  double least = top;
  for (Line& line : lines) {
    line.label_y = std::max(line.label_y, least);
    least = line.label_y + line_of_text;
  }
}

std::string grid(const Axes& axes) {
  std::string svg;
  for (double decade = axes.y0; decade <= axes.y1; ++decade) {
    const double y = axes.y(std::pow(10, decade));
    svg += fmt::format(
        "<line class='grid' x1='{0}' x2='{1}' y1='{2:.1f}' y2='{2:.1f}'/><text x='{3}' y='{4:.1f}' "
        "text-anchor='end'>{5:g}</text>\n",
        left, panel_width - right, y, left - 6, y + 4, std::pow(10, decade));
  }
  for (double decade = axes.x0; decade <= axes.x1; ++decade) {
    const double x = axes.x(std::pow(10, decade));
    svg += fmt::format(
        "<line class='grid' x1='{0:.1f}' x2='{0:.1f}' y1='{1}' y2='{2}'/><text x='{0:.1f}' y='{3}' "
        "text-anchor='middle'>{4:g}</text>\n",
        x, top, panel_height - bottom, panel_height - bottom + 32, std::pow(10, decade));
  }
  return svg + fmt::format("<text x='{}' y='{:.1f}' text-anchor='end'>exact</text>\n", left - 6, axes.y(0) + 4);
}

/// The class in the style sheet: one for ours, one per library.
std::string style_of(const Line& line) {
  if (line.points.front()->whose == "ours") return "default";
  std::string library = line.name.substr(0, line.name.find_first_of(". "));
  std::ranges::transform(library, library.begin(), [](char c) { return 'A' <= c && c <= 'Z' ? c - 'A' + 'a' : c; });
  return library;
}

std::string drawn(const Line& line, const Axes& axes) {
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

std::string panel(const std::vector<WorkPrecision>& rows, const std::string& workload, const Axes& axes,
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
  const Axes axes = axes_of(rows);
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
