#include "oracle/truth/feature_gap.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "oracle/truth/world_points.h"
#include "reference/rational.h"

namespace touchstone::oracle {
namespace {

// The feature's vertices in W; empty if the feature names something that does not exist.
Points claimed(const Body& body, const Feature& feature) {
  const Points all = world_points(body, feature.part);
  Points points;
  for (const int i : feature.vertices) {
    if (i < 0 || i >= static_cast<int>(all.size())) return {};
    points.push_back(all[static_cast<std::size_t>(i)]);
  }
  return points;
}

Real unit_clamp(Real t) { return std::clamp<Real>(t, 0, 1); }

Real point_segment(const Point& p, const Point& a, const Point& b) {
  const Point d = b - a;
  const Real dd = d.squaredNorm();
  return (p - a - d * (dd > 0 ? unit_clamp((p - a).dot(d) / dd) : 0)).norm();
}

// Candidates: the points where the common normal of the two lines meets either segment, each with the nearest point of
// the other segment, and the ends. The cross product keeps the digits of a small angle, which |u|² |v|² − (u·v)² loses:
// s and t are off by some ulps over its sine, which moves a point away from the other line by some ulps.
Real segment_segment(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point u = b - a, v = d - c, w = c - a, n = u.cross(v);
  const Real nn = n.squaredNorm();
  Real least =
      std::min({point_segment(a, c, d), point_segment(b, c, d), point_segment(c, a, b), point_segment(d, a, b)});
  if (nn > 0) {
    const Real s = unit_clamp(w.cross(v).dot(n) / nn), t = unit_clamp(w.cross(u).dot(n) / nn);
    least = std::min({least, point_segment(a + u * s, c, d), point_segment(c + v * t, a, b)});
  }
  return least;
}

// The perpendicular foot of p in the triangle; its edges are other candidates. In a slender triangle s and t are
// inexact, and the remainder shows by how much: one step of refinement.
Real point_triangle(const Point& p, const Point& a, const Point& b, const Point& c) {
  const Point u = b - a, v = c - a, w = p - a, n = u.cross(v);
  const Real nn = n.squaredNorm();
  if (!(nn > 0)) return std::numeric_limits<Real>::infinity();
  const Real s = w.cross(v).dot(n) / nn, t = u.cross(w).dot(n) / nn;
  if (s < 0 || t < 0 || s + t > 1) return std::numeric_limits<Real>::infinity();
  const Point left = w - u * s - v * t;
  return (left - u * (left.cross(v).dot(n) / nn) - v * (u.cross(left).dot(n) / nn)).norm();
}

Real to_triangles(const Points& points, const Points& corners) {
  Real least = std::numeric_limits<Real>::infinity();
  for (const Point& p : points)
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        for (std::size_t k = 0; k < j; ++k)
          least = std::min(least, point_triangle(p, corners[i], corners[j], corners[k]));
  return least;
}

// i == j is a segment of length 0, the vertex itself.
Real between_segments(const Points& A, const Points& B) {
  Real least = std::numeric_limits<Real>::infinity();
  for (std::size_t i = 0; i < A.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j)
      for (std::size_t k = 0; k < B.size(); ++k)
        for (std::size_t l = 0; l <= k; ++l) least = std::min(least, segment_segment(A[i], A[j], B[k], B[l]));
  return least;
}

/// Perpendicular to the triangle, as long as twice its area. From the corner between the two shorter sides: two long
/// sides of a sliver are nearly parallel, and their cross product is off by rounding of their lengths.
Point normal_of(const Point& a, const Point& b, const Point& c) {
  const Real ab = (b - a).squaredNorm(), bc = (c - b).squaredNorm(), ca = (a - c).squaredNorm();
  if (ab >= bc && ab >= ca) return (a - c).cross(b - c);
  return bc >= ca ? (b - a).cross(c - a) : (c - b).cross(a - b);
}

using Triangle = std::array<std::size_t, 3>;  // indices into the claimed vertices

/// `heights`: of all vertices of the part above the plane through the first claimed one.
double off_plane(const Feature& feature, const std::vector<double>& heights) {
  double off = 0;
  for (const int i : feature.vertices) off = std::max(off, std::abs(heights[static_cast<std::size_t>(i)]));
  const auto [lowest, highest] = std::ranges::minmax(heights);
  return std::max(off, std::min(highest, -lowest));
}

std::vector<double> heights_above(const Points& all, const Point& origin, const Point& n) {
  std::vector<double> heights;
  for (const Point& p : all) heights.push_back(static_cast<double>(n.dot(p - origin)));
  return heights;
}

/// The same without rounding, in the part's own frame: a triangle that is 10⁹ times as long as wide extends the
/// rounding of its plane as many times. 0 if the corners are on one line.
std::vector<double> exact_heights(const Body& body, const Feature& feature, const Triangle& triangle) {
  using reference::Rational;
  const std::vector<Vec3> all = own_vertices(body, feature.part);
  const auto claimed_vertex = [&](std::size_t i) { return all[static_cast<std::size_t>(feature.vertices[i])]; };
  const auto minus = [](const Vec3& p, const Vec3& q) {
    return std::array<Rational, 3>{Rational(p.x()) - q.x(), Rational(p.y()) - q.y(), Rational(p.z()) - q.z()};
  };
  const Vec3 corner = claimed_vertex(triangle[0]), origin = claimed_vertex(0);
  const auto u = minus(claimed_vertex(triangle[1]), corner), v = minus(claimed_vertex(triangle[2]), corner);
  const std::array<Rational, 3> n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const Rational nn = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
  std::vector<double> heights(all.size());
  if (nn.sign() == 0) return heights;
  std::ranges::transform(all, heights.begin(), [&](const Vec3& p) {
    const auto w = minus(p, origin);
    const Rational h = n[0] * w[0] + n[1] * w[1] + n[2] * w[2];
    return h.sign() * std::sqrt((h * h / nn).nearest());
  });
  return heights;
}

}  // namespace

std::optional<double> feature_gap(const Body& A, const Feature& feature_A, const Body& B, const Feature& feature_B) {
  const Points a = claimed(A, feature_A), b = claimed(B, feature_B);
  if (a.empty() || b.empty()) return std::nullopt;
  return static_cast<double>(std::min({between_segments(a, b), to_triangles(a, b), to_triangles(b, a)}));
}

double off_one_face(const Body& body, const Feature& feature) {
  const Points points = claimed(body, feature), all = world_points(body, feature.part);
  Triangle widest{};
  Point normal = Point::Zero(), along = Point::Zero();
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if ((points[j] - points[i]).squaredNorm() > along.squaredNorm()) along = points[j] - points[i];
      for (std::size_t k = 0; k < j; ++k) {
        const Point n = normal_of(points[i], points[j], points[k]);
        if (!(n.squaredNorm() > normal.squaredNorm())) continue;
        normal = n;
        widest = {i, j, k};
      }
    }
  if (!(normal.squaredNorm() > 0)) return 0;
  const Real off_line = normal.norm() / along.norm();  // the height of the widest triangle, about
  const double off = off_plane(feature, heights_above(all, points[0], normal.normalized()));
  if (off <= 0x1p-56 * static_cast<double>(along.norm())) return off;
  return std::min(static_cast<double>(off_line), off_plane(feature, exact_heights(body, feature, widest)));
}

}  // namespace touchstone::oracle
