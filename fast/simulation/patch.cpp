#include "fast/simulation/patch.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "fast/lin_canny/solid.h"

namespace touchstone::fast::simulation {
namespace {

using Vec2 = Eigen::Vector2d;

/// Two axes across n, which map points into the plane and back.
struct Plane {
  explicit Plane(const Vec3& n) : x(n.unitOrthogonal()), y(n.cross(x)) {}
  Vec2 seen(const Vec3& p) const { return {x.dot(p), y.dot(p)}; }
  Vec3 x, y;
};

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The counter-clockwise convex hull of the points, without points on its sides. Source: Andrew 1979, the monotone
/// chain.
std::vector<Vec2> hull(std::vector<Vec2> points) {
  std::ranges::sort(points,
                    [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  if (points.size() < 3) return points;
  std::vector<Vec2> chain;
  const auto add_half = [&](auto first, auto last) {
    const std::size_t start = chain.size();
    for (auto p = first; p != last; ++p) {
      while (chain.size() >= start + 2 && cross(chain.back() - chain[chain.size() - 2], *p - chain.back()) <= 0) {
        chain.pop_back();
      }
      chain.push_back(*p);
    }
    chain.pop_back();
  };
  add_half(points.begin(), points.end());
  add_half(points.rbegin(), points.rend());
  return chain;
}

/// The part of the subject (a point, a segment or a polygon) to the left of a → b.
std::vector<Vec2> left_of(const std::vector<Vec2>& subject, const Vec2& a, const Vec2& b) {
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < subject.size(); ++i) {
    const Vec2 &p = subject[i], &q = subject[(i + 1) % subject.size()];
    const double at_p = cross(b - a, p - a), at_q = cross(b - a, q - a);
    if (at_p >= 0) kept.push_back(p);
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) kept.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return kept;
}

/// The hull, in the plane, of a part's vertices within `within` of its extent along `out`, and that extent.
struct Outline {
  std::vector<Vec2> corners;
  double height = 0;
};

Outline outline(const lin_canny::Convex& part, const lin_canny::CachedPose& body, const Vec3& out, const Plane& plane,
                double within) {
  const lin_canny::PosedHull placed = lin_canny::posed_hull(part, body, Vec3::Zero());
  double height = -std::numeric_limits<double>::infinity();
  for (int v = 0; v < placed.hull->vertex_count(); ++v) height = std::max(height, out.dot(placed.vertex(v)));
  std::vector<Vec2> corners;
  for (int v = 0; v < placed.hull->vertex_count(); ++v) {
    const Vec3 p = placed.vertex(v);
    if (out.dot(p) >= height - within) corners.push_back(plane.seen(p));
  }
  return {hull(std::move(corners)), height + part.radius};
}

/// The intersection of two outlines. Empty if neither is a polygon, as for a single vertex or two crossing edges: then
/// the contact is a point.
std::vector<Vec2> common(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  const auto& [clip, subject] = a.size() >= b.size() ? std::tie(a, b) : std::tie(b, a);
  if (clip.size() < 3) return {};
  std::vector<Vec2> rest = subject;
  for (std::size_t i = 0; i < clip.size() && !rest.empty(); ++i) {
    rest = left_of(rest, clip[i], clip[(i + 1) % clip.size()]);
  }
  return rest;
}

}  // namespace

std::vector<Vec3> patch(const BodyMotion& a, const BodyMotion& b, double t, const Vec3& n, const Vec3& p_WC,
                        double within) {
  const Plane plane(n);
  const lin_canny::CachedPose at_a(a.ballistic().pose(t)), at_b(b.ballistic().pose(t));
  std::vector<Vec3> corners;
  for (const lin_canny::Convex& part_a : a.model().solid.parts()) {
    const Outline of_a = outline(part_a, at_a, -n, plane, within);
    for (const lin_canny::Convex& part_b : b.model().solid.parts()) {
      const Outline of_b = outline(part_b, at_b, n, plane, within);
      if (std::abs(of_a.height + of_b.height) > 2 * within) continue;
      const double between = (of_b.height - of_a.height) / 2;
      for (const Vec2& p : common(of_a.corners, of_b.corners)) {
        corners.push_back(p.x() * plane.x + p.y() * plane.y + between * n);
      }
    }
  }
  if (corners.empty()) corners.push_back(p_WC);
  return corners;
}

bool supports(const std::vector<Vec3>& corners, const Vec3& nhat_W, const Vec3& p_W) {
  const Plane plane(nhat_W);
  std::vector<Vec2> seen;
  for (const Vec3& corner : corners) seen.push_back(plane.seen(corner));
  const std::vector<Vec2> rim = hull(std::move(seen));
  if (rim.size() < 3) return false;
  const Vec2 p = plane.seen(p_W);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Vec2 &from = rim[i], &to = rim[(i + 1) % rim.size()];
    if (!(cross(to - from, p - from) > 0)) return false;
  }
  return true;
}

}  // namespace touchstone::fast::simulation
