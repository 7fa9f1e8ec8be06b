#include "app/report/page/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "app/report/wire_part.h"
#include "model/sequence.h"
#include "oracle/truth/truth.h"

namespace touchstone::app {
namespace {

using oracle::Real;

constexpr double side = 180;  // of a view, in SVG units
constexpr double margin = 20;

/// The projection from the world to the page: the axes `right` and `up`.
struct View {
  int right;
  int up;
  const char* title;
  double left;  ///< left edge of the view on the page
  Real scale;
  oracle::Point centre;

  double x(const oracle::Point& p) const {
    return left + side / 2 + static_cast<double>((p[right] - centre[right]) * scale);
  }
  double y(const oracle::Point& p) const { return side / 2 - static_cast<double>((p[up] - centre[up]) * scale); }
};

std::string line(const View& view, const oracle::Point& a, const oracle::Point& b, const std::string& style) {
  return fmt::format("<line class=\"{}\" x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\"/>", style, view.x(a),
                     view.y(a), view.x(b), view.y(b));
}

std::string dot(const View& view, const oracle::Point& p, const std::string& style, double radius) {
  return fmt::format("<circle class=\"{}\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"/>", style, view.x(p), view.y(p),
                     radius);
}

struct Dot {
  double x;
  double y;
};

/// > 0 if a, b, c turn left.
double turn(const Dot& a, const Dot& b, const Dot& c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

void add_chain(const std::vector<Dot>& dots, std::vector<Dot>& hull) {
  const std::size_t start = hull.size();
  for (const Dot& dot : dots) {
    while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), dot) <= 0) hull.pop_back();
    hull.push_back(dot);
  }
  hull.pop_back();
}

/// The outline of a part: the hull of its points on the page, by Andrew's monotone chains.
std::vector<Dot> outline(const WirePart& part, const View& view) {
  std::vector<Dot> dots;
  for (const oracle::Point& p : part.points) dots.push_back({view.x(p), view.y(p)});
  std::ranges::sort(dots, {}, [](const Dot& dot) { return std::pair(dot.x, dot.y); });
  std::vector<Dot> hull;
  add_chain(dots, hull);
  std::ranges::reverse(dots);
  add_chain(dots, hull);
  return hull;
}

std::string style_of(const WirePart& part) { return fmt::format("body-{}", std::min(part.body, 2)); }

std::string filled(const WirePart& part, const View& view) {
  if (part.radius > 0) return "";
  std::string corners;
  for (const Dot& dot : outline(part, view)) corners += fmt::format("{:.2f},{:.2f} ", dot.x, dot.y);
  return fmt::format("<polygon class=\"{}\" points=\"{}\"/>", style_of(part), corners);
}

/// A ring around a body that is only a speck on the page; else empty.
std::string ring_around_speck(const WirePart& part, const View& view) {
  constexpr double speck = 3;
  Dot lo{side * 2, side};
  Dot hi{0, 0};
  for (const oracle::Point& p : part.points) {
    lo = {std::min(lo.x, view.x(p)), std::min(lo.y, view.y(p))};
    hi = {std::max(hi.x, view.x(p)), std::max(hi.y, view.y(p))};
  }
  const double extent = std::max(hi.x - lo.x, hi.y - lo.y) + 2 * static_cast<double>(part.radius * view.scale);
  return extent < speck ? dot(view, part.points[0], style_of(part) + " ring", 6) : "";
}

Dot middle(const WirePart& part, const View& view) {
  Dot sum{0, 0};
  for (const oracle::Point& p : part.points) sum = {sum.x + view.x(p), sum.y + view.y(p)};
  const auto count = static_cast<double>(part.points.size());
  return {sum.x / count, sum.y / count};
}

/// "A" or "B" beside the corner that is farthest from the other body's middle, above or below that corner.
std::string name_tag(const WirePart& part, const WirePart& other, const View& view) {
  const Dot away_from = middle(other, view);
  const auto farthest = std::ranges::max_element(part.points, {}, [&](const oracle::Point& p) {
    return std::hypot(view.x(p) - away_from.x, view.y(p) - away_from.y);
  });
  const double reach = static_cast<double>(part.radius * view.scale);
  const double x = view.x(*farthest);
  const double y = view.y(*farthest) + (view.y(*farthest) < away_from.y ? -reach - 4 : reach + 11);
  return fmt::format("<text class=\"{}\" x=\"{:.2f}\" y=\"{:.2f}\">{}</text>", style_of(part), x, y,
                     static_cast<char>('A' + part.body));
}

std::string wire_frame(const WirePart& part, const View& view) {
  const std::string style = style_of(part);
  std::string svg = filled(part, view) + ring_around_speck(part, view);
  for (const auto& [i, j] : part.edges) {
    svg += line(view, part.points[static_cast<std::size_t>(i)], part.points[static_cast<std::size_t>(j)], style);
  }
  if (part.radius > 0) svg += dot(view, part.points[0], style, static_cast<double>(part.radius * view.scale));
  return svg;
}

std::string witnesses(const Scene& scene, const View& view) {
  if (scene.bodies.size() != 2) return "";
  const reference::DistanceTruth& truth = oracle::truth::distance(scene);
  if (truth.verdict == Verdict::overlapping) return "";
  const oracle::Point a = truth.p_WCa.cast<Real>();
  const oracle::Point b = truth.p_WCb.cast<Real>();
  return line(view, a, b, "witness") + dot(view, a, "witness", 2.5) + dot(view, b, "witness", 2.5);
}

}  // namespace

std::string picture(const Scene& scene) {
  if (is_sequence(scene)) return picture(snapshot(scene, scene.frames.size() - 1));
  const std::vector<WirePart> parts = wire_parts(scene);
  oracle::Point lo = oracle::Point::Constant(std::numeric_limits<Real>::infinity());
  oracle::Point hi = -lo;
  for (const WirePart& part : parts) {
    if (part.points.size() > most_drawn) return "";
    for (const oracle::Point& p : part.points) {
      lo = lo.cwiseMin(p - oracle::Point::Constant(part.radius));
      hi = hi.cwiseMax(p + oracle::Point::Constant(part.radius));
    }
  }
  const Real extent = (hi - lo).maxCoeff();
  if (!(extent > 0) || !std::isfinite(extent)) return "";
  const Real scale = static_cast<Real>(side - 2 * margin) / extent;
  const oracle::Point centre = lo + (hi - lo) / 2;
  std::string svg = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">", 2 * side, side + 18,
                                "the scene from above and from the front");
  for (const View& view :
       {View{0, 1, "x right, y up", 0, scale, centre}, View{0, 2, "x right, z up", side, scale, centre}}) {
    for (const WirePart& part : parts) svg += wire_frame(part, view);
    if (scene.bodies.size() == 2) {
      svg += name_tag(parts.front(), parts.back(), view) + name_tag(parts.back(), parts.front(), view);
    }
    svg += witnesses(scene, view);
    svg += fmt::format("<text x=\"{}\" y=\"{}\">{}</text>", view.left + side / 2, side + 13, view.title);
  }
  return svg + "</svg>";
}

}  // namespace touchstone::app
