#include "app/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "model/input_error.h"
#include "oracle/truth.h"
#include "oracle/world_points.h"

namespace touchstone::app {
namespace {

using oracle::Points;
using Real = oracle::Real;
using Edges = std::set<std::pair<int, int>>;

constexpr double side = 180;  // of a view, in SVG units
constexpr double margin = 20;

/// One convex part, in W: points and the edges between them, or a ball.
struct Drawn {
  int body = 0;
  Points points;
  Edges edges;
  double radius = 0;
};

Edges edges_of(const Sphere&) { return {}; }

Edges edges_of(const Box&) {
  Edges edges;
  for (int i = 0; i < 8; ++i) {
    for (const int bit : {1, 2, 4}) {
      if ((i & bit) == 0) edges.emplace(i, i | bit);
    }
  }
  return edges;
}

Edges edges_of(const Polytope& polytope) {
  Edges edges;
  for (const std::vector<int>& face : polytope.faces) {
    for (std::size_t k = 0; k < face.size(); ++k) edges.insert(std::minmax(face[k], face[(k + 1) % face.size()]));
  }
  return edges;
}

double radius_of(const ConvexShape& shape) {
  const auto* sphere = std::get_if<Sphere>(&shape);
  return sphere != nullptr ? sphere->radius : 0;
}

std::vector<ConvexShape> parts_of(const Shape& shape) {
  std::vector<ConvexShape> parts;
  if (const auto* compound = std::get_if<Compound>(&shape)) {
    for (const Part& part : compound->parts) parts.push_back(part.shape);
  } else {
    std::visit(
        [&](const auto& convex) {
          if constexpr (!std::is_same_v<std::decay_t<decltype(convex)>, Compound>) parts.emplace_back(convex);
        },
        shape);
  }
  return parts;
}

std::vector<Drawn> drawn(const Scene& scene) {
  std::vector<Drawn> all;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const std::vector<ConvexShape> parts = parts_of(scene.bodies[b].shape);
    for (std::size_t p = 0; p < parts.size(); ++p) {
      all.push_back({static_cast<int>(b), oracle::world_points(scene.bodies[b], static_cast<int>(p)),
                     std::visit([](const auto& shape) { return edges_of(shape); }, parts[p]), radius_of(parts[p])});
    }
  }
  return all;
}

/// From the world to the page: two of the axes, the second one upwards.
struct View {
  int right;
  int up;
  const char* title;
  double left;  ///< of the view on the page
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

/// > 0: a, b, c turn to the left.
double turn(const Dot& a, const Dot& b, const Dot& c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

void add_chain(const std::vector<Dot>& dots, std::vector<Dot>& hull) {
  const std::size_t start = hull.size();
  for (const Dot& dot : dots) {
    while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), dot) <= 0) hull.pop_back();
    hull.push_back(dot);
  }
  hull.pop_back();
}

/// The outline of a part: the hull of its points on the page, by Andrew's two chains.
std::vector<Dot> outline(const Drawn& part, const View& view) {
  std::vector<Dot> dots;
  for (const oracle::Point& p : part.points) dots.push_back({view.x(p), view.y(p)});
  std::ranges::sort(dots, {}, [](const Dot& dot) { return std::pair(dot.x, dot.y); });
  std::vector<Dot> hull;
  add_chain(dots, hull);
  std::ranges::reverse(dots);
  add_chain(dots, hull);
  return hull;
}

std::string style_of(const Drawn& part) { return fmt::format("body-{}", std::min(part.body, 2)); }

std::string filled(const Drawn& part, const View& view) {
  if (part.radius > 0) return "";
  std::string corners;
  for (const Dot& dot : outline(part, view)) corners += fmt::format("{:.2f},{:.2f} ", dot.x, dot.y);
  return fmt::format("<polygon class=\"{}\" points=\"{}\"/>", style_of(part), corners);
}

/// A body that is a speck on this page gets a ring around it.
std::string ring_around_speck(const Drawn& part, const View& view) {
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

/// "A" or "B" beside the corner that is farthest from the page's middle, above it or below it.
std::string name_tag(const Drawn& part, const View& view) {
  const double x_middle = view.left + side / 2;
  const auto farthest = std::ranges::max_element(
      part.points, {}, [&](const oracle::Point& p) { return std::hypot(view.x(p) - x_middle, view.y(p) - side / 2); });
  const double reach = static_cast<double>(part.radius * view.scale);
  const double x = view.x(*farthest);
  const double y = view.y(*farthest) + (view.y(*farthest) < side / 2 ? -reach - 4 : reach + 11);
  return fmt::format("<text class=\"{}\" x=\"{:.2f}\" y=\"{:.2f}\">{}</text>", style_of(part), x, y,
                     static_cast<char>('A' + part.body));
}

std::string wire_frame(const Drawn& part, const View& view) {
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
  const std::vector<Drawn> parts = drawn(scene);
  oracle::Point lo = oracle::Point::Constant(std::numeric_limits<Real>::infinity());
  oracle::Point hi = -lo;
  for (const Drawn& part : parts) {
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
    int tagged = -1;
    for (const Drawn& part : parts) {
      svg += wire_frame(part, view);
      if (scene.bodies.size() == 2 && part.body != tagged) svg += name_tag(part, view);
      tagged = part.body;
    }
    svg += witnesses(scene, view);
    svg += fmt::format("<text x=\"{}\" y=\"{}\">{}</text>", view.left + side / 2, side + 13, view.title);
  }
  return svg + "</svg>";
}

}  // namespace touchstone::app
