#include "fast/contact/manifold.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "fast/contact/clip_polygon.h"
#include "fast/contact/support.h"

namespace touchstone::fast::contact {
namespace {

using Kind = Feature::Kind;

constexpr double is_parallel = 0x1p-10;  // sine of the angle below which two edges may touch in more than a crossing
// Times `within`: so small that even at a sharp corner of a face a contact point is on the face within `within`.
constexpr double beside = 0x1p-4;
// Times `within`: faces whose corners are that near to the other part's face are nearly parallel to it. Their outermost
// corners may hang over its sides, and then it is corners of its own that touch.
constexpr double nearly_parallel = 0x1p10;

/// The vertices that are outermost along `out`, as a polygon seen from outside; the face behind them if they are at
/// least three.
struct Outline {
  std::vector<Vec3> corners;
  Vec3 normal = Vec3::Zero();  ///< outward, of the face
};

Outline outline(const Part& part, const Vec3& out, double within) {
  const lin_canny::Hull& hull = *part.core.hull;
  std::vector<double> height;
  for (int v = 0; v < hull.vertex_count(); ++v) height.push_back(out.dot(part.core.vertex(v)));
  const double least = *std::ranges::max_element(height) - within;
  const auto is_outermost = [&](int v) { return height[static_cast<std::size_t>(v)] >= least; };
  Outline seen;
  if (std::ranges::count_if(height, [&](double h) { return h >= least; }) < 3) {
    for (int v = 0; v < hull.vertex_count(); ++v) {
      if (is_outermost(v)) seen.corners.push_back(part.core.vertex(v));
    }
    return seen;
  }
  const int face = supporting_face(part.core, out).face;
  return {face_corners(part.core, face), face_normal(part.core, face)};
}

/// The part of a point, a segment or a polygon that is over a face, or at most `slack` beside it.
std::vector<Vec3> over_face(std::vector<Vec3> rest, const Outline& face, double slack) {
  for (std::size_t i = 0; i < face.corners.size() && !rest.empty(); ++i) {
    const Vec3 &on = face.corners[i], along = face.corners[(i + 1) % face.corners.size()] - on;
    const Vec3 inward = face.normal.cross(along).normalized();
    const bool is_segment = rest.size() == 2;
    rest = clip_polygon(rest, [&](const Vec3& p) { return inward.dot(p - on) + slack; });
    if (is_segment && rest.size() == 3) rest.pop_back();  // the crossing, found from the other end too
  }
  return rest;
}

/// Whether B's face is the one on which corners of the other part lie. Of two faces it is the one that has more corners
/// of the other over it: when a cube on a table begins to tip, its corners stay on the table, whose face pushes.
bool is_on_face_of_B(const Outline& of_A, const Outline& of_B, double slack) {
  if (of_A.corners.size() < 3 || of_B.corners.size() < 3) return of_B.corners.size() >= 3;
  const auto count_over = [slack](const Outline& other, const Outline& face) {
    return std::ranges::count_if(other.corners, [&](const Vec3& p) { return !over_face({p}, face, slack).empty(); });
  };
  return count_over(of_A, of_B) >= count_over(of_B, of_A);
}

Feature point(const Part& part, const Vec3& p_W) {
  return {Kind::point, part.body.in(p_W), Vec3::Zero(), part.convex->radius};
}

Feature plane(const Part& part, const Vec3& on_W, const Vec3& out_W) {
  return {Kind::plane, part.body.in(on_W), part.body.R_WB.transpose() * out_W, 0};
}

Feature line(const Part& part, const Outline& edge) {
  const Vec3 along = (edge.corners[1] - edge.corners[0]).normalized();
  return {Kind::line, part.body.in(edge.corners[0]), part.body.R_WB.transpose() * along, 0};
}

/// The ends of the interval that two parallel edges have in common.
std::vector<Vec3> common_of_edges(const Outline& a, const Outline& b) {
  const Vec3 along = (a.corners[1] - a.corners[0]).normalized();
  std::vector<Vec3> ends = a.corners;
  ends.insert(ends.end(), b.corners.begin(), b.corners.end());
  std::ranges::stable_sort(ends, {}, [&](const Vec3& p) { return along.dot(p); });
  return {ends[1], ends[2]};
}

/// The corners of what is over a face of B, or of A, and at most `highest` above it.
std::vector<ContactPoint> points_on_face(const Part& A, const Outline& of_A, const Part& B, const Outline& of_B,
                                         bool is_face_of_B, double slack, double highest) {
  std::vector<ContactPoint> made;
  const Outline &face = is_face_of_B ? of_B : of_A, &other = is_face_of_B ? of_A : of_B;
  const double radius = (is_face_of_B ? A : B).convex->radius;
  for (const Vec3& p : over_face(other.corners, face, slack)) {
    if (face.normal.dot(p - face.corners[0]) - radius > highest) continue;
    if (is_face_of_B) {
      made.push_back({point(A, p), plane(B, face.corners[0], face.normal)});
    } else {
      made.push_back({plane(A, face.corners[0], face.normal), point(B, p)});
    }
  }
  return made;
}

/// Whether an edge ends more than `within` before the place where its line is nearest to that of the other edge; if the
/// two are parallel, there is no such place.
bool ends_before_crossing(const Outline& edge, const Outline& other, double within) {
  const Vec3 side = edge.corners[1] - edge.corners[0], e = (other.corners[1] - other.corners[0]).normalized();
  const double length = side.norm();
  const Vec3 d = side / length, between = other.corners[0] - edge.corners[0], across = d.cross(e);
  const double along = between.cross(e).dot(across) / across.squaredNorm();
  return !(along >= -within && along <= length + within);
}

/// Whether a corner is more than `within` beside a corner or an edge, seen along n. Where rounding tilts n, the lowest
/// corner of a part may be far from where the two are near.
bool is_beside(const Vec3& corner, const Outline& other, const Vec3& n, double within) {
  Vec3 nearest = other.corners[0];
  if (other.corners.size() == 2) {
    const Vec3 side = other.corners[1] - nearest;
    nearest += std::clamp(side.dot(corner - nearest) / side.squaredNorm(), 0.0, 1.0) * side;
  }
  const Vec3 off = corner - nearest;
  return (off - n.dot(off) * n).norm() > within;
}

std::vector<ContactPoint> points_without_face(const Part& A, const Outline& of_A, const Part& B, const Outline& of_B,
                                              const Vec3& n, double within) {
  const std::size_t a = of_A.corners.size(), b = of_B.corners.size();
  if (a == 2 && b == 2) {
    const Vec3 d = (of_A.corners[1] - of_A.corners[0]).normalized();
    if (d.cross((of_B.corners[1] - of_B.corners[0]).normalized()).norm() <= is_parallel) {
      std::vector<ContactPoint> made;
      for (const Vec3& p : common_of_edges(of_A, of_B)) {
        // Of long edges that are hardly parallel, one end may be far beside the other edge.
        if (is_beside(p, of_A, n, within) || is_beside(p, of_B, n, within)) continue;
        made.push_back({point(A, p), plane(B, of_B.corners[0], n)});
      }
      if (!made.empty()) return made;
    }
    if (ends_before_crossing(of_A, of_B, within) || ends_before_crossing(of_B, of_A, within)) return {};
    return {{line(A, of_A), line(B, of_B)}};
  }
  if (is_beside(a == 1 ? of_A.corners[0] : of_B.corners[0], a == 1 ? of_B : of_A, n, within)) return {};
  if (A.is_ball() || B.is_ball()) {
    return {{a == 2 ? line(A, of_A) : point(A, of_A.corners[0]), b == 2 ? line(B, of_B) : point(B, of_B.corners[0])}};
  }
  // A corner at a corner or an edge: the plane perpendicular to n separates them.
  if (a == 1) return {{point(A, of_A.corners[0]), plane(B, of_B.corners[0], n)}};
  return {{plane(A, of_A.corners[0], -n), point(B, of_B.corners[0])}};
}

}  // namespace

std::vector<ContactPoint> contact_points(const Part& A, const Part& B, const Vec3& n, double within) {
  const Outline of_A = outline(A, -n, within), of_B = outline(B, n, within);
  const bool face_of_A = of_A.corners.size() >= 3, face_of_B = of_B.corners.size() >= 3;
  if (!face_of_A && !face_of_B) return points_without_face(A, of_A, B, of_B, n, within);
  const double slack = beside * within;
  if (!face_of_A || !face_of_B) {
    const Outline wide_A = face_of_A ? of_A : outline(A, -n, nearly_parallel * within),
                  wide_B = face_of_B ? of_B : outline(B, n, nearly_parallel * within);
    std::vector<ContactPoint> points =
        points_on_face(A, wide_A, B, wide_B, is_on_face_of_B(wide_A, wide_B, slack), slack, within);
    if (!points.empty()) return points;
  }
  return points_on_face(A, of_A, B, of_B, is_on_face_of_B(of_A, of_B, slack), slack, within);
}

ContactPoint contact_point_between(const Part& A, const Vec3& p_Wa, const Part& B, const Vec3& p_Wb, const Vec3& n) {
  return {{Kind::point, A.body.in(p_Wa), Vec3::Zero(), 0}, plane(B, p_Wb, n)};
}

}  // namespace touchstone::fast::contact
