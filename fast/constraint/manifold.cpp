#include "fast/constraint/manifold.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "fast/lin_canny/parting_normals.h"

namespace touchstone::fast::constraint {
namespace {

constexpr double faces_meet = 0.9;         // cos 25°
constexpr double is_normal = 1 - 0x1p-20;  // a normal from two points 2⁻³⁰ apart has an error of at most 2⁻²²

struct Facing {
  int face = -1;
  double cosine = -1;
  Vec3 normal_W = Vec3::Zero();
};

/// The face whose outward normal is nearest to d.
Facing facing(const StepperBody& body, const Vec3& d_W) {
  const lin_canny::Hull& hull = body.convex().core;
  const Vec3 d = body.R_WB().transpose() * d_W;
  Facing best;
  for (int f = 0; f < hull.face_count(); ++f) {
    const double cosine = hull.face(f).normal.dot(d);
    if (cosine <= best.cosine) continue;
    best.face = f;
    best.cosine = cosine;
  }
  if (best.face >= 0) best.normal_W = body.R_WB() * hull.face(best.face).normal;
  return best;
}

Vec3 vertex(const StepperBody& body, int v) {
  const Pose X_WB = body.pose();
  return body.R_WB() * body.convex().core.vertex(v) + X_WB.p_WB;
}

std::vector<Vec3> corners(const StepperBody& body, int face) {
  const lin_canny::Hull& hull = body.convex().core;
  const lin_canny::Hull::Face& f = hull.face(face);
  std::vector<Vec3> points;
  for (int i = 0; i < f.corner_count; ++i) points.push_back(vertex(body, hull.corner(f.first_corner + i)));
  return points;
}

/// The part of the polygon on that side of the plane through `on` to which `inward` points.
std::vector<Vec3> cut(const std::vector<Vec3>& polygon, const Vec3& on, const Vec3& inward) {
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double at_p = inward.dot(p - on), at_q = inward.dot(q - on);
    if (at_p >= 0) kept.push_back(p);
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) kept.emplace_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return kept;
}

/// Corners of B's face within A's, projected along n, each with its gap to the plane of A's face.
std::vector<ContactPoint> common(const std::vector<Vec3>& face_A, const Vec3& normal_A, const std::vector<Vec3>& face_B,
                                 const Vec3& n) {
  std::vector<Vec3> polygon = face_B;
  for (std::size_t i = 0; i < face_A.size(); ++i) {
    const Vec3 along = face_A[(i + 1) % face_A.size()] - face_A[i];
    // Counter-clockwise seen from outside A, that is from B; n points the other way.
    polygon = cut(polygon, face_A[i], along.cross(n));
  }
  std::vector<ContactPoint> points;
  for (const Vec3& p : polygon) {
    const double gap = normal_A.dot(face_A.front() - p) / normal_A.dot(n);
    points.push_back({p + gap / 2 * n, gap});
  }
  return points;
}

/// The minimum of n·x over the body.
double least(const StepperBody& body, const Vec3& n) {
  const lin_canny::Hull& hull = body.convex().core;
  double low = n.dot(vertex(body, 0));
  for (int v = 1; v < hull.vertex_count(); ++v) low = std::min(low, n.dot(vertex(body, v)));
  return low - body.convex().radius;
}

/// The separation of the two bodies along n.
double apart_along(const StepperBody& A, const StepperBody& B, const Vec3& n) { return least(A, n) + least(B, -n); }

/// The normal of greatest separation among planes parallel to a face of either body or to an edge of each. Needed for
/// bodies that touch when the motion begins: a separating plane is among these.
Vec3 separating(const StepperBody& A, const StepperBody& B) {
  const auto core = [](const StepperBody& body) {
    return lin_canny::posed_hull(body.convex(), lin_canny::CachedPose(body.pose()), Vec3::Zero());
  };
  return lin_canny::widest_parting_normal(core(A), core(B), [&](const Vec3& n) { return apart_along(A, B, n); });
}

bool is_ball(const StepperBody& body) { return body.convex().core.vertex_count() == 1; }

Vec3 normal(const StepperBody& A, const StepperBody& B, const lin_canny::Proximity& near,
            const std::optional<Vec3>& before) {
  // A ball is represented by its centre, which is far from the other body's point.
  const Vec3 a = is_ball(A) ? A.pose().p_WB : near.p_WCa, b = is_ball(B) ? B.pose().p_WB : near.p_WCb;
  const Vec3 apart = a - b;
  const double size = apart.norm();
  const bool touch_at_a_ball = near.verdict == Verdict::touching && (is_ball(A) || is_ball(B));
  if ((near.verdict == Verdict::separated || touch_at_a_ball) && size > 0) return apart / size;
  return before ? *before : separating(A, B);
}

}  // namespace

Manifold manifold(const StepperBody& A, const StepperBody& B, const lin_canny::Proximity& near,
                  const std::optional<Vec3>& before) {
  Manifold made{normal(A, B, near, before), {}};
  Vec3& n = made.nhat_BA_W;
  const Facing of_A = facing(A, -n), of_B = facing(B, n);
  if (of_B.cosine > is_normal) {
    n = of_B.normal_W;
  } else if (of_A.cosine > is_normal) {
    n = -of_A.normal_W;
  }
  if (of_A.cosine > faces_meet && of_B.cosine > faces_meet) {
    made.points = common(corners(A, of_A.face), of_A.normal_W, corners(B, of_B.face), n);
  }
  if (made.points.empty()) {
    const bool apart = near.verdict == Verdict::separated;
    const double gap = apart ? near.distance : apart_along(A, B, n);
    made.points = {{apart ? Vec3((near.p_WCa + near.p_WCb) / 2) : Vec3(near.p_WCa - gap / 2 * n), gap}};
  }
  const double from_middle = A.is_fixed() ? -0.5 : B.is_fixed() ? 0.5 : 0;
  for (ContactPoint& point : made.points) point.p_WC += from_middle * point.gap * n;
  return made;
}

}  // namespace touchstone::fast::constraint
