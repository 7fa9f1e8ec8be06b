#include "fast/contact/patch.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "fast/contact/clip_polygon.h"
#include "fast/contact/support.h"

namespace touchstone::fast::contact {
namespace {

using Vec2 = Eigen::Vector2d;

/// Two axes across n, which map points into the plane and back.
struct PlaneAxes {
  explicit PlaneAxes(const Vec3& n) : x(n.unitOrthogonal()), y(n.cross(x)) {}
  Vec2 seen(const Vec3& p) const { return {x.dot(p), y.dot(p)}; }
  Vec3 x, y;
};

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The counter-clockwise convex hull of the points, without points on its sides. Source: Andrew 1979, the monotone
/// chain.
std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
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

/// The hull, in the plane, of a part's vertices within `within` of its extent along `out`, and that extent.
struct PlaneOutline {
  std::vector<Vec2> corners;
  double height = 0;
};

PlaneOutline plane_outline(const lin_canny::Convex& part, const lin_canny::CachedPose& body, const Vec3& out,
                           const PlaneAxes& plane, double within) {
  const lin_canny::PosedHull core = lin_canny::posed_hull(part, body, Vec3::Zero());
  const double height = -lowest(core, -out);
  std::vector<Vec2> corners;
  for (int v = 0; v < core.hull->vertex_count(); ++v) {
    const Vec3 p = core.vertex(v);
    if (out.dot(p) >= height - within) corners.push_back(plane.seen(p));
  }
  return {convex_hull(std::move(corners)), height + part.radius};
}

/// The intersection of two outlines. Empty if neither is a polygon, as for a single vertex or two crossing edges: then
/// the contact is a point.
std::vector<Vec2> common(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  const auto& [clip, subject] = a.size() >= b.size() ? std::tie(a, b) : std::tie(b, a);
  if (clip.size() < 3) return {};
  std::vector<Vec2> rest = subject;
  for (std::size_t i = 0; i < clip.size() && !rest.empty(); ++i) {
    const Vec2 &from = clip[i], &to = clip[(i + 1) % clip.size()];
    rest = clip_polygon(rest, [&](const Vec2& p) { return cross(to - from, p - from); });
  }
  return rest;
}

}  // namespace

std::vector<Vec3> patch(const lin_canny::Solid& A, const lin_canny::CachedPose& at_A, const lin_canny::Solid& B,
                        const lin_canny::CachedPose& at_B, const Vec3& n, const Vec3& p_WC, double within) {
  const PlaneAxes plane(n);
  std::vector<Vec3> corners;
  for (const lin_canny::Convex& part_A : A.parts()) {
    const PlaneOutline of_A = plane_outline(part_A, at_A, -n, plane, within);
    for (const lin_canny::Convex& part_B : B.parts()) {
      const PlaneOutline of_B = plane_outline(part_B, at_B, n, plane, within);
      if (std::abs(of_A.height + of_B.height) > 2 * within) continue;
      const double between = (of_B.height - of_A.height) / 2;
      for (const Vec2& p : common(of_A.corners, of_B.corners)) {
        corners.push_back(p.x() * plane.x + p.y() * plane.y + between * n);
      }
    }
  }
  if (corners.empty()) corners.push_back(p_WC);
  return corners;
}

bool supports(const std::vector<Vec3>& corners, const Vec3& nhat_W, const Vec3& p_W) {
  const PlaneAxes plane(nhat_W);
  std::vector<Vec2> seen;
  for (const Vec3& corner : corners) seen.push_back(plane.seen(corner));
  const std::vector<Vec2> rim = convex_hull(std::move(seen));
  if (rim.size() < 3) return false;
  const Vec2 p = plane.seen(p_W);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Vec2 &from = rim[i], &to = rim[(i + 1) % rim.size()];
    if (!(cross(to - from, p - from) > 0)) return false;
  }
  return true;
}

}  // namespace touchstone::fast::contact
