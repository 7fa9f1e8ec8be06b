#include "fast/contact/manifold.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "fast/lin_canny/parting_normals.h"

namespace touchstone::fast::contact {
namespace {

using Vec2 = Eigen::Vector2d;
using Kind = Feature::Kind;

constexpr double is_normal = 1 - 0x1p-41;  // cos 2⁻²⁰
constexpr double is_aligned = 0.9;         // cos 25°
constexpr double is_parallel = 0x1p-10;    // sine of the angle below which two edges have no unique crossing
// Times `within`: so small that even at a sharp corner of a face a contact point is on the face within `within`.
constexpr double beside = 0x1p-4;
constexpr double rounds = 0x1p-48;  // of the sizes
// Shares of the sizes: a longer connection has a direction beyond rounding, or even one so accurate that no corner is
// misplaced.
constexpr double has_direction = 0x1p-34;
constexpr double has_accurate_direction = 0x1p-16;

/// The vertices that are outermost along `out`, as a polygon seen from outside; the face behind them if they are at
/// least three.
struct Outline {
  std::vector<Vec3> corners;
  Vec3 normal = Vec3::Zero();  ///< outward, of the face
};

int facing(const Part& part, const Vec3& out) {
  const lin_canny::Hull& hull = *part.core.hull;
  const Vec3 d = part.core.turned_in(out);
  int best = 0;
  for (int f = 1; f < hull.face_count(); ++f) {
    if (hull.face(f).normal.dot(d) > hull.face(best).normal.dot(d)) best = f;
  }
  return best;
}

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
  const lin_canny::Hull::Face& face = hull.face(facing(part, out));
  seen.normal = part.core.turned_out(face.normal);
  for (int i = 0; i < face.corner_count; ++i)
    seen.corners.push_back(part.core.vertex(hull.corner(face.first_corner + i)));
  return seen;
}

/// The part of a point, a segment or a polygon that is over a face, or at most `slack` beside it.
std::vector<Vec3> clipped(std::vector<Vec3> rest, const Outline& by, double slack) {
  for (std::size_t i = 0; i < by.corners.size() && !rest.empty(); ++i) {
    const Vec3 &on = by.corners[i], along = by.corners[(i + 1) % by.corners.size()] - on;
    const Vec3 inward = by.normal.cross(along).normalized();
    std::vector<Vec3> kept;
    for (std::size_t k = 0; k < rest.size(); ++k) {
      const Vec3 &p = rest[k], &q = rest[(k + 1) % rest.size()];
      const double at_p = inward.dot(p - on) + slack, at_q = inward.dot(q - on) + slack;
      if (at_p >= 0) kept.push_back(p);
      const bool crosses = (at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0);
      if (crosses && (rest.size() > 2 || k == 0)) kept.emplace_back(p + at_p / (at_p - at_q) * (q - p));
    }
    rest = std::move(kept);
  }
  return rest;
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

std::vector<ContactPoint> points_on_face(const Part& A, const Outline& of_A, const Part& B, const Outline& of_B,
                                         double slack) {
  std::vector<ContactPoint> made;
  const bool plane_of_B = of_B.corners.size() >= 3;
  const Outline &face = plane_of_B ? of_B : of_A, &other = plane_of_B ? of_A : of_B;
  for (const Vec3& p : clipped(other.corners, face, slack)) {
    if (plane_of_B) {
      made.push_back({point(A, p), plane(B, face.corners[0], face.normal)});
    } else {
      made.push_back({plane(A, face.corners[0], face.normal), point(B, p)});
    }
  }
  return made;
}

std::vector<ContactPoint> points_without_face(const Part& A, const Outline& of_A, const Part& B, const Outline& of_B,
                                              const Vec3& n) {
  const std::size_t a = of_A.corners.size(), b = of_B.corners.size();
  if (A.is_ball() || B.is_ball()) {
    return {{a == 2 ? line(A, of_A) : point(A, of_A.corners[0]), b == 2 ? line(B, of_B) : point(B, of_B.corners[0])}};
  }
  if (a == 2 && b == 2) {
    const Vec3 d = (of_A.corners[1] - of_A.corners[0]).normalized();
    if (d.cross((of_B.corners[1] - of_B.corners[0]).normalized()).norm() > is_parallel) {
      return {{line(A, of_A), line(B, of_B)}};
    }
    std::vector<ContactPoint> made;
    for (const Vec3& p : common_of_edges(of_A, of_B)) made.push_back({point(A, p), plane(B, of_B.corners[0], n)});
    return made;
  }
  // A corner at a corner or an edge: the plane perpendicular to n separates them.
  if (a == 1) return {{point(A, of_A.corners[0]), plane(B, of_B.corners[0], n)}};
  return {{plane(A, of_A.corners[0], -n), point(B, of_B.corners[0])}};
}

/// The minimum of n·x over the core.
double lowest(const Part& part, const Vec3& n) {
  double low = std::numeric_limits<double>::infinity();
  for (int v = 0; v < part.core.hull->vertex_count(); ++v) low = std::min(low, n.dot(part.core.vertex(v)));
  return low;
}

std::vector<Vec3> faces_within(const Part& A, const Part& B, const Vec3& n, double cosine) {
  std::vector<Vec3> normals;
  if (!B.is_ball()) normals.push_back(B.core.turned_out(B.core.hull->face(facing(B, n)).normal));
  if (!A.is_ball()) normals.push_back(-A.core.turned_out(A.core.hull->face(facing(A, -n)).normal));
  std::erase_if(normals, [&](const Vec3& normal) { return normal.dot(n) <= cosine; });
  return normals;
}

}  // namespace

Part part_of(const lin_canny::Convex& convex, const lin_canny::CachedPose& cached_pose, const RigidTransform& body) {
  return {&convex, lin_canny::posed_hull(convex, cached_pose, Vec3::Zero()), body};
}

std::vector<ContactPoint> contact_points(const Part& A, const Part& B, const Vec3& n, double within) {
  const Outline of_A = outline(A, -n, within), of_B = outline(B, n, within);
  if (of_A.corners.size() < 3 && of_B.corners.size() < 3) return points_without_face(A, of_A, B, of_B, n);
  return points_on_face(A, of_A, B, of_B, beside * within);
}

std::vector<double> clearances(const Part& A, const Part& B, const Vec3& n) {
  std::vector<double> all;
  const double low = lowest(A, n), high = -lowest(B, -n), radii = A.convex->radius + B.convex->radius;
  for (int v = 0; v < A.core.hull->vertex_count(); ++v) all.push_back(n.dot(A.core.vertex(v)) - high - radii);
  for (int v = 0; v < B.core.hull->vertex_count(); ++v) all.push_back(low - n.dot(B.core.vertex(v)) - radii);
  return all;
}

double apart(const Part& A, const Part& B, const Vec3& n) {
  return lowest(A, n) + lowest(B, -n) - (A.convex->radius + B.convex->radius);
}

ContactPoint contact_point_between(const Part& A, const Vec3& p_Wa, const Part& B, const Vec3& p_Wb, const Vec3& n) {
  return {{Kind::point, A.body.in(p_Wa), Vec3::Zero(), 0}, plane(B, p_Wb, n)};
}

std::vector<Vec3> faces_along(const Part& A, const Part& B, const Vec3& n) { return faces_within(A, B, n, is_aligned); }

Vec3 parting(const Part& A, const Part& B, const lin_canny::Proximity& near) {
  const Vec3 a = A.is_ball() ? A.core.vertex(0) : near.p_WCa, b = B.is_ball() ? B.core.vertex(0) : near.p_WCb;
  const Vec3 way = a - b;
  const double far = way.norm(), size = A.convex->reach + B.convex->reach;
  const bool is_true = near.verdict != Verdict::overlapping || A.is_ball() || B.is_ball();
  const auto direction = [&]() -> Vec3 {
    if (is_true && far > has_accurate_direction * size) return way / far;
    const Vec3 of_plane =
        lin_canny::widest_parting_normal(A.core, B.core, [&](const Vec3& n) { return apart(A, B, n); });
    if (!(is_true && far > has_direction * size)) return of_plane;
    const Vec3 of_way = way / far;
    return apart(A, B, of_way) > apart(A, B, of_plane) ? of_way : of_plane;
  };
  const Vec3 n = direction();
  const double least = apart(A, B, n) - rounds * size;
  for (const Vec3& face : faces_within(A, B, n, is_normal)) {
    if (apart(A, B, face) >= least) return face;
  }
  return n;
}

}  // namespace touchstone::fast::contact
