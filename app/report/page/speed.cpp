#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/report/chart.h"
#include "app/report/page/page.h"
#include "app/report/timing_json.h"
#include "app/report/xml.h"
#include "app/trial/subject_list.h"
#include "model/infinity.h"
#include "oracle/query.h"
#include "oracle/tolerance/precision.h"

namespace touchstone::app::page {
namespace {

/// The property whose errors stand for a query: the one that compares the answer itself with the exact value.
const std::map<std::string, std::string> measured_by = {
    {"mass", "mass.inertia"},           {"bounds", "bounds.tight"},
    {"distance", "distance.value"},     {"penetration", "penetration.depth"},
    {"impulse", "impulse.agrees"},      {"time_of_impact", "time_of_impact.agrees"},
    {"simulation", "simulation.solid"}, {"constraint", "constraint.agrees"}};

const std::string ulps = "ulps of ";

/// The coarsest arithmetic that the card declares for the query, whatever the shapes.
oracle::Precision coarsest(const oracle::Card& card, const std::string& query) {
  oracle::Precision found = card.precision;
  for (const auto& [part, precision] : card.precision_of) {
    if (part == query || oracle::find_query(part) == nullptr) found = std::max(found, precision);
  }
  return found;
}

/// One subject of one query.
struct Point {
  const TestedSubject* subject = nullptr;
  const Row* row = nullptr;  ///< of the property that measures the query; null: none does
  const RunTimes* times = nullptr;
  double unit = 1;  ///< what an error of 1 is, as a share of what the plot's axis says
  Counts counts;    ///< of all properties of the query

  bool has_error() const { return row != nullptr && row->errors.total() > 0; }
  double largest() const { return unit * row->errors.largest; }
  double median() const { return unit * row->errors.median(); }
  bool can_be_drawn() const { return times->total() > 0 && has_error(); }
};

/// "the scene's scale" of "ulps of the scene's scale", "m".
std::string quantity(const std::string& unit) { return unit.starts_with(ulps) ? unit.substr(ulps.size()) : unit; }

std::string axis_title(const std::string& unit) {
  return unit.starts_with(ulps) ? "error, as a share of " + quantity(unit) : "error, " + unit;
}

Counts counts_of(const Ledger& ledger, const ResultMatrix::Properties& properties, const TestedSubject& subject) {
  Counts counts;
  for (const properties::Property* property : properties) {
    counts += ledger.results.of(*property)[subject.index].counts;
  }
  return counts;
}

/// The subjects that answered, the fastest first.
std::vector<Point> points_of(const Ledger& ledger, const ResultMatrix::Properties& properties,
                             const QueryProfile& profile) {
  const std::string& query = properties.front()->query;
  const auto measure = measured_by.find(query);
  const auto property = std::ranges::find_if(properties, [&](const properties::Property* candidate) {
    return measure != measured_by.end() && candidate->id == measure->second;
  });
  std::vector<Point> points;
  for (const TestedSubject& subject : ledger.subjects) {
    Point point{&subject, nullptr, &profile.times.answers[subject.index], 1, counts_of(ledger, properties, subject)};
    if (point.counts.answered() == 0) continue;
    if (property != properties.end()) {
      point.row = &ledger.results.of(**property)[subject.index];
      if (point.row->errors.unit.starts_with(ulps)) {
        point.unit = oracle::unit_roundoff(coarsest(subject.card, query));
      }
    }
    points.push_back(point);
  }
  std::ranges::stable_sort(
      points, {}, [](const Point& point) { return point.times->total() > 0 ? point.times->quantile(0.5) : infinity; });
  return points;
}

std::string seconds(double s) {
  if (s < 1e-3) return fmt::format("{:.3g} µs", 1e6 * s);
  return s < 1 ? fmt::format("{:.3g} ms", 1e3 * s) : fmt::format("{:.3g} s", s);
}

std::string size_of_error(double error) {
  if (std::isinf(error)) return "infinite";
  return error > 0 ? fmt::format("{:.2g}", error) : "exact";
}

constexpr double width = 760;
constexpr double left = 74;
constexpr double right = 190;  ///< for the names
constexpr double top = 30;
constexpr double below = 62;  ///< for the row of exact answers, the numbers and the title
constexpr double least_height = 300;

/// Of the rows below and above the axis.
std::string row_title(const char* title, double y) {
  return fmt::format("<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n", left - 6, y + 4, title);
}

LogAxes axes_of(const std::vector<const Point*>& points) {
  const double height = std::max(least_height, line_of_text * static_cast<double>(points.size()));
  LogAxes axes{left, width - right, top, top + height};
  for (const Point* point : points) {
    axes.include_x(1e6 * point->times->quantile(0.5));
    for (const double error : {point->largest(), point->median()}) {
      if (error > 0 && std::isfinite(error)) axes.include_y(error);
    }
  }
  axes.close();
  return axes;
}

/// A dot at the largest error, and a line down to the median one.
std::string drawn(const Point& point, const LogAxes& axes, double name_y) {
  const std::string name = escaped(point.subject->card.name);
  const double x = axes.x(1e6 * point.times->quantile(0.5));
  const double y = axes.y(point.largest()), median_y = axes.y(point.median());
  const bool ours = name == "fast" || name == "reference" || name.starts_with("fast.");
  const bool single = point.subject->card.precision == oracle::Precision::binary32;
  return fmt::format(
      "<a href=\"#{0}\" data-subject=\"{1}\" class=\"{2}\"><title>{1}: {3}, largest error {4}, median at most "
      "{5}</title><line x1=\"{6:.1f}\" x2=\"{6:.1f}\" y1=\"{7:.1f}\" y2=\"{8:.1f}\"/><circle class=\"{9}\" "
      "cx=\"{6:.1f}\" cy=\"{7:.1f}\" r=\"4\"/><line class=\"lead\" x1=\"{6:.1f}\" y1=\"{7:.1f}\" x2=\"{10:.1f}\" "
      "y2=\"{11:.1f}\"/><text x=\"{12:.1f}\" y=\"{13:.1f}\">{1}</text></a>\n",
      subject_anchor(*point.subject), name, ours ? "ours" : "other", seconds(point.times->quantile(0.5)),
      size_of_error(point.largest()), size_of_error(point.median()), x, y, median_y, single ? "single" : "double",
      axes.right + 10, name_y, axes.right + 13, name_y + 4);
}

std::string plot(const std::string& query, const std::vector<Point>& points) {
  std::vector<const Point*> shown;
  for (const Point& point : points) {
    if (point.can_be_drawn()) shown.push_back(&point);
  }
  if (shown.empty()) return "<p class=\"soft\">No plot: the errors of these answers have no size.</p>";
  const LogAxes axes = axes_of(shown);
  std::vector<double> wanted;
  for (const Point* point : shown) wanted.push_back(axes.y(point->largest()));
  const std::vector<double> heights = apart(wanted, axes.top - LogAxes::above, axes.bottom + LogAxes::below);
  std::string svg = axes.rows() + axes.columns(32) + row_title("exact", axes.y(0));
  if (std::ranges::any_of(shown, [](const Point* point) { return std::isinf(point->largest()); })) {
    svg += row_title("infinite", axes.y(infinity));
  }
  for (std::size_t i = 0; i < shown.size(); ++i) svg += drawn(*shown[i], axes, heights[i]);
  const double middle = (axes.top + axes.bottom) / 2;
  svg += fmt::format(
      "<text x=\"{0}\" y=\"{1}\" text-anchor=\"middle\">CPU time of a question, median, µs</text><text x=\"13\" "
      "y=\"{2}\" text-anchor=\"middle\" transform=\"rotate(-90 13 {2})\">{3}</text>",
      (axes.left + axes.right) / 2, axes.bottom + below - 8, middle,
      escaped(axis_title(shown.front()->row->errors.unit)));
  return scrolling("Plot of " + query,
                   fmt::format("<svg class=\"plot\" role=\"group\" aria-label=\"{}: error against CPU time; the table "
                               "below has the numbers\" viewBox=\"0 0 {} {}\">{}</svg>",
                               query, width, axes.bottom + below, svg));
}

std::string share_cell(long some, long all) {
  return some == 0 ? "<td></td>" : fmt::format("<td>{}</td>", percent(some, all));
}

std::string number_row(const Point& point) {
  const Counts& counts = point.counts;
  const long all = counts.all();
  const std::string time = point.times->total() == 0
                               ? "<td></td><td></td>"
                               : fmt::format("<td>{}</td><td>{} to {}</td>", seconds(point.times->quantile(0.5)),
                                             seconds(point.times->quantile(0.1)), seconds(point.times->quantile(0.9)));
  const std::string errors = point.has_error()
                                 ? fmt::format("<td>{}</td><td>{}</td><td>{}</td>", size_of_error(point.median()),
                                               size_of_error(point.largest()), point.row->errors.total())
                                 : "<td></td><td></td><td></td>";
  return fmt::format("<tr data-subject=\"{0}\"><th scope=\"row\">{0}{1}</th>{2}{3}", escaped(point.subject->card.name),
                     is_in_process(point.subject->connectable) ? " <small>in process</small>" : "", time, errors) +
         share_cell(counts.abstains, all) + share_cell(counts.breaks + counts.refused + counts.unanswered, all) +
         share_cell(counts.outside, all) + share_cell(counts.beyond, all) + share_cell(counts.not_asked, all) + "</tr>";
}

std::string numbers(const std::string& query, const std::vector<Point>& points) {
  std::string html =
      "<table><thead><tr><th scope=\"col\">subject</th><th scope=\"col\">CPU time, median</th><th scope=\"col\">of "
      "eight tenths</th><th scope=\"col\">error, median at most</th><th scope=\"col\">largest</th><th "
      "scope=\"col\">answers with an error’s size</th>";
  for (const char* left_out : {"abstains", "broken", "outside", "beyond its domain", "not asked"}) {
    html += fmt::format("<th scope=\"col\">{}</th>", left_out);
  }
  html += "</tr></thead><tbody>";
  for (const Point& point : points) html += number_row(point);
  return "<details><summary>The numbers, and what was left out</summary>" +
         scrolling("Error and time of " + query, html + "</tbody></table>") + "</details>";
}

std::string undrawn(const std::vector<Point>& points) {
  std::vector<std::string> names;
  for (const Point& point : points) {
    if (!point.can_be_drawn()) names.push_back(escaped(point.subject->card.name));
  }
  if (names.empty() || names.size() == points.size()) return "";
  return fmt::format("<p class=\"soft\">Not drawn, since no answer has an error with a size: {}.</p>",
                     fmt::join(names, ", "));
}

std::string query_speed(const Ledger& ledger, const ResultMatrix::Properties& properties, const QueryProfile& profile) {
  const std::string& query = properties.front()->query;
  const std::vector<Point> points = points_of(ledger, properties, profile);
  if (points.empty()) return "";
  const auto measure = measured_by.find(query);
  const std::string says =
      measure == measured_by.end()
          ? ""
          : fmt::format("<p class=\"soft\">Error: of <code>{}</code>, against the exact value.</p>", measure->second);
  return fmt::format("<section id=\"speed.{0}\"><h3>{0}</h3>{1}{2}{3}{4}</section>", query, says, plot(query, points),
                     undrawn(points), numbers(query, points));
}

std::string saved_by_plans(const Ledger& ledger) {
  std::string html;
  for (const auto& [query, profile] : ledger.profiles) {
    const PlanTimes& times = profile.times.plans;
    if (times.planned.total() == 0 || times.all_parts.total() == 0) continue;
    const double planned = times.planned.quantile(0.5), all = times.all_parts.quantile(0.5);
    html += fmt::format(
        "<p>What <a href=\"#left-out\">leaving out</a> saves: the pairs of a sequence of <code>{}</code> take "
        "<code>fast</code> {} by its plan and {} with all parts, in this process, CPU time, medians of {}.</p>",
        query, seconds(planned), seconds(all), plural(times.planned.total(), "sequence"));
  }
  return html;
}

}  // namespace

std::string speed(const Ledger& ledger) {
  std::string html = fmt::format(
      "<p>A dot is the largest error of a subject’s answers, the end of its line the median one (rounded up to a power "
      "of two); hollow: single precision, whose errors are shown in the same unit. Further left is faster, further "
      "down is more accurate. {} The times are of one run on one machine, perhaps beside other work: they are in "
      "<a href=\"report.timing.json\">report.timing.json</a>, and no verdict depends on them. <span "
      "class=\"soft\">Made by the command of this report; <code>touchstone bench distance</code> measures without "
      "JSON.</span></p>",
      escaped(time_contents));
  for (const ResultMatrix::Properties& properties : ledger.results.by_query()) {
    const auto profile = ledger.profiles.find(properties.front()->query);
    if (profile != ledger.profiles.end()) html += query_speed(ledger, properties, profile->second);
  }
  return html + saved_by_plans(ledger);
}

}  // namespace touchstone::app::page
