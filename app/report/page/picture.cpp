#include "app/report/page/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "app/report/page/marks.h"
#include "app/report/wire_part.h"
#include "model/sequence.h"

namespace touchstone::app {
namespace {

using oracle::Real;

constexpr double side = 180;  // of a view, in SVG units
constexpr double margin = 20;

/// The projection from the world to the page: the axes `right` and `up`, about the middle of the view.
struct View {
  int right;
  int up;
  const char* title;
  bool turns;  ///< by the script: its elements have their coordinates in space
  Real scale;
  oracle::Point centre;

  double x(const oracle::Point& p) const { return static_cast<double>((p[right] - centre[right]) * scale); }
  double y(const oracle::Point& p) const { return static_cast<double>((centre[up] - p[up]) * scale); }

  /// Points in the page's unit about the middle: "x,y,z x,y,z".
  std::string in_space(const oracle::Points& points) const {
    if (!turns) return "";
    std::string words;
    for (const oracle::Point& p : points) {
      const oracle::Point q = (p - centre) * scale;
      words += fmt::format("{}{:.1f},{:.1f},{:.1f}", words.empty() ? "" : " ", static_cast<double>(q.x()),
                           static_cast<double>(q.y()), static_cast<double>(q.z()));
    }
    return fmt::format(" data-at=\"{}\"", words);
  }
};

std::string line(const View& view, const oracle::Point& a, const oracle::Point& b) {
  return fmt::format("M{:.2f} {:.2f}L{:.2f} {:.2f}", view.x(a), view.y(a), view.x(b), view.y(b));
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
  Dot lo{side, side};
  Dot hi{-side, -side};
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
  const double aside = view.y(*farthest) < away_from.y ? -reach - 4 : reach + 11;
  return fmt::format("<text class=\"{}\" x=\"{:.2f}\" y=\"{:.2f}\" dy=\"{:.2f}\"{}>{}</text>", style_of(part),
                     view.x(*farthest), view.y(*farthest), aside, view.in_space({*farthest}),
                     static_cast<char>('A' + part.body));
}

std::string wire_frame(const WirePart& part, const View& view) {
  std::string lines, ends;
  for (const auto& [i, j] : part.edges) {
    lines += line(view, part.points[static_cast<std::size_t>(i)], part.points[static_cast<std::size_t>(j)]);
    if (view.turns) ends += fmt::format("{}{} {}", ends.empty() ? "" : " ", i, j);
  }
  std::string svg =
      fmt::format("<g{}>", view.in_space(part.points)) + filled(part, view) + ring_around_speck(part, view);
  if (!lines.empty()) {
    svg += fmt::format("<path class=\"{}\"{} d=\"{}\"/>", style_of(part),
                       view.turns ? " data-edges=\"" + ends + '"' : "", lines);
  }
  if (part.radius > 0) svg += dot(view, part.points[0], style_of(part), static_cast<double>(part.radius * view.scale));
  return svg + "</g>";
}

/// The head of an arrow: two short lines at its end, of which the script draws the same.
std::string head_of_arrow(const View& view, const Mark& mark) {
  const Dot a{view.x(mark.from), view.y(mark.from)}, b{view.x(mark.to), view.y(mark.to)};
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  if (length < 1) return "";
  const Dot along{6 * (b.x - a.x) / length, 6 * (b.y - a.y) / length};
  const auto end = [&](double s) {
    return fmt::format("{:.2f} {:.2f}", b.x - along.x + s * along.y / 2, b.y - along.y - s * along.x / 2);
  };
  return fmt::format("M{}L{:.2f} {:.2f}L{}", end(1), b.x, b.y, end(-1));
}

std::string drawn(const Mark& mark, const View& view) {
  std::string svg = fmt::format("<g{}><path class=\"{}{}\" d=\"{}{}\"/>", view.in_space({mark.from, mark.to}),
                                mark.style, mark.arrow ? " arrow" : "", line(view, mark.from, mark.to),
                                mark.arrow ? head_of_arrow(view, mark) : "");
  if (!mark.arrow) {
    svg += dot(view, mark.from, mark.style, 2.5);
    svg += fmt::format("<circle class=\"{}\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"2.50\" data-end=\"1\"/>", mark.style,
                       view.x(mark.to), view.y(mark.to));
  }
  return svg + "</g>";
}

/// The box around all that is drawn.
struct Around {
  oracle::Point lo = oracle::Point::Constant(std::numeric_limits<Real>::infinity());
  oracle::Point hi = -lo;

  void add(const oracle::Point& p, Real radius) {
    lo = lo.cwiseMin(p - oracle::Point::Constant(radius));
    hi = hi.cwiseMax(p + oracle::Point::Constant(radius));
  }
  Real extent() const { return (hi - lo).maxCoeff(); }
  oracle::Point centre() const { return lo + (hi - lo) / 2; }
};

bool too_large(const std::vector<WirePart>& parts) {
  return std::ranges::any_of(parts, [](const WirePart& part) { return part.points.size() > most_drawn; });
}

Around around(const std::vector<WirePart>& parts) {
  Around box;
  for (const WirePart& part : parts) {
    for (const oracle::Point& p : part.points) box.add(p, part.radius);
  }
  return box;
}

std::string svg_of(const Scene& scene, const std::vector<WirePart>& parts, const std::vector<Mark>& marks,
                   const Around& box) {
  const Real scale = static_cast<Real>(side - 2 * margin) / box.extent();
  std::string svg = fmt::format("<svg class=\"turns\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">", 2 * side,
                                side + 18, "the scene from above and from the front");
  double left = 0;
  for (const View& view : {View{0, 1, "x right, y up", false, scale, box.centre()},
                           View{0, 2, "x right, z up", true, scale, box.centre()}}) {
    svg += fmt::format("<g{} transform=\"translate({} {})\">", view.turns ? " class=\"front\"" : "", left + side / 2,
                       side / 2);
    for (const WirePart& part : parts) svg += wire_frame(part, view);
    if (scene.bodies.size() == 2) {
      svg += name_tag(parts.front(), parts.back(), view) + name_tag(parts.back(), parts.front(), view);
    }
    for (const Mark& mark : marks) svg += drawn(mark, view);
    svg += fmt::format("</g><text x=\"{}\" y=\"{}\">{}</text>", left + side / 2, side + 13, view.title);
    left += side;
  }
  return svg + "</svg>";
}

/// The marks of a scene or a case, given the extent of its bodies; a mark that lies far off is left out.
template <class MarksOf>
std::string picture_with(const Scene& scene, const MarksOf& marks_in) {
  const std::vector<WirePart> parts = wire_parts(scene);
  if (too_large(parts)) return "";
  Around box = around(parts);
  const Real extent = box.extent();
  if (!(extent > 0) || !std::isfinite(extent)) return "";
  Marks marks = marks_in(extent);
  const oracle::Point centre = box.centre();
  std::erase_if(marks.lines, [&](const Mark& mark) {
    const auto far = [&](const oracle::Point& p) { return !((p - centre).norm() <= 2 * extent); };
    return far(mark.from) || far(mark.to);
  });
  for (const Mark& mark : marks.lines) box.add(mark.from, 0), box.add(mark.to, 0);
  const std::string svg = svg_of(scene, parts, marks.lines, box);
  if (marks.key.empty()) return svg;
  return "<figure>" + svg + "<figcaption>" + marks.key + "</figcaption></figure>";
}

}  // namespace

std::string picture(const Scene& scene) {
  if (is_sequence(scene)) return picture(snapshot(scene, scene.frames.size() - 1));
  return picture_with(scene, [&](Real) { return marks_of(scene); });
}

std::string picture(const oracle::Case& a_case) {
  if (is_sequence(a_case.scene)) return picture(a_case.scene);
  return picture_with(a_case.scene, [&](Real extent) { return marks_of(a_case, extent); });
}

}  // namespace touchstone::app
