#include "app/report/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace touchstone::app {

void LogAxes::include_x(double value) {
  x0 = std::min(x0, std::floor(std::log10(value)));
  x1 = std::max(x1, std::ceil(std::log10(value) + 1e-9));
}

void LogAxes::include_x_as_edge(double value) {
  x0 = std::min(x0, std::log10(value));
  x1 = std::max(x1, std::log10(value));
}

void LogAxes::include_y(double value) {
  y0 = std::min(y0, std::floor(std::log10(value)));
  y1 = std::max(y1, std::ceil(std::log10(value) + 1e-9));
}

void LogAxes::close() {
  if (x0 > x1) x0 = 0, x1 = 1;
  if (x0 == x1) x1 = x0 + 1e-9;
  if (y0 > y1) y0 = -1, y1 = 1;
}

double LogAxes::x(double value) const { return left + (std::log10(value) - x0) / (x1 - x0) * (right - left); }

double LogAxes::y(double value) const {
  if (!(value > 0)) return bottom + below;
  if (std::isinf(value)) return top - above;
  return bottom - (std::log10(value) - y0) / (y1 - y0) * (bottom - top);
}

std::string LogAxes::rows() const {
  std::string svg;
  const double step = std::max(1.0, std::ceil((y1 - y0) * 1.3 * line_of_text / (bottom - top)));
  for (double decade = y0; decade <= y1; decade += step) {
    const double height = y(std::pow(10, decade));
    svg += fmt::format(
        "<line class='grid' x1='{0}' x2='{1}' y1='{2:.1f}' y2='{2:.1f}'/><text x='{3}' y='{4:.1f}' "
        "text-anchor='end'>{5:g}</text>\n",
        left, right, height, left - 6, height + 4, std::pow(10, decade));
  }
  return svg;
}

std::string LogAxes::column(double value, const std::string& name, double under) const {
  return fmt::format(
      "<line class='grid' x1='{0:.1f}' x2='{0:.1f}' y1='{1}' y2='{2}'/><text x='{0:.1f}' y='{3}' "
      "text-anchor='middle'>{4}</text>\n",
      x(value), top, bottom, bottom + under, name);
}

std::string LogAxes::columns(double under) const {
  std::string svg;
  for (double decade = x0; decade <= x1; ++decade) {
    const double value = std::pow(10, decade);
    svg += column(value, fmt::format("{:g}", value), under);
  }
  return svg;
}

std::vector<double> apart(const std::vector<double>& wanted, double top, double bottom) {
  std::vector<std::size_t> order(wanted.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return wanted[i]; });
  std::vector<double> heights = wanted;
  double least = top;
  for (const std::size_t i : order) {
    heights[i] = std::max(heights[i], least);
    least = heights[i] + line_of_text;
  }
  double greatest = std::max(
      bottom, top + line_of_text * static_cast<double>(wanted.size() - std::min<std::size_t>(1, wanted.size())));
  for (auto i = order.rbegin(); i != order.rend(); ++i) {
    heights[*i] = std::min(heights[*i], greatest);
    greatest = heights[*i] - line_of_text;
  }
  return heights;
}

}  // namespace touchstone::app
