#include "fast/contact/gap_manifold.h"

#include <Eigen/Geometry>

#include "fast/contact/clip_polygon.h"
#include "fast/contact/support.h"
#include "fast/lin_canny/parting_normals.h"
#include "fast/rounding.h"

namespace touchstone::fast::contact {
namespace {

constexpr double faces_oppose = 0.9;            // cos 25°
constexpr double is_face_normal = 1 - 0x1p-20;  // a normal from two points 2⁻³⁰ apart has an error of at most 2⁻²²
constexpr double gives_direction = 0x1p10;  // roundings: nearer points have a direction that is off by more than 2⁻¹⁰
// A normal is kept while the overlap along it is at most so many times the least one. When a body turns about an edge,
// its first normal would soon say that the two are deep in each other.
constexpr double kept_up_to = 2;

/// Corners of B's face within A's, projected along n, each with its gap to the plane of A's face.
std::vector<GapPoint> common_corners(const std::vector<Vec3>& face_A, const Vec3& normal_A,
                                     const std::vector<Vec3>& face_B, const Vec3& n) {
  std::vector<Vec3> polygon = face_B;
  for (std::size_t i = 0; i < face_A.size(); ++i) {
    // Counter-clockwise seen from outside A, that is from B; n points the other way.
    const Vec3 &on = face_A[i], inward = Vec3(face_A[(i + 1) % face_A.size()] - on).cross(n);
    polygon = clip_polygon(polygon, [&](const Vec3& p) { return inward.dot(p - on); });
  }
  std::vector<GapPoint> points;
  for (const Vec3& p : polygon) {
    const double gap = normal_A.dot(face_A.front() - p) / normal_A.dot(n);
    points.push_back({p + gap / 2 * n, gap});
  }
  return points;
}

/// The separation along n. Each part's radius is subtracted from its own extent, and not both at the end, as `apart`
/// (parting.h) does: for a ball the two differ in the last bits.
double gap_along(const Part& A, const Part& B, const Vec3& n) {
  return (lowest(A.core, n) - A.convex->radius) + (lowest(B.core, -n) - B.convex->radius);
}

Vec3 gap_normal(const Part& A, const Part& B, const lin_canny::Proximity& near, const std::optional<Vec3>& before) {
  // A ball is represented by its centre, which is far from the other body's point.
  const Vec3 a = A.is_ball() ? A.core.t : near.p_WCa, b = B.is_ball() ? B.core.t : near.p_WCb;
  const Vec3 way = a - b;
  const double size = way.norm(), rounding = 2 * u * (a.lpNorm<1>() + b.lpNorm<1>());
  const bool touch_at_a_ball = near.verdict == Verdict::touching && (A.is_ball() || B.is_ball());
  const bool is_apart = near.verdict == Verdict::separated || touch_at_a_ball;
  if (is_apart && size > gives_direction * rounding) return way / size;
  // Of bodies that touch when the motion begins, a separating plane is among these.
  const Vec3 widest =
      lin_canny::widest_parting_normal(A.core, B.core, [&](const Vec3& n) { return gap_along(A, B, n); });
  return before && !is_apart && gap_along(A, B, *before) >= kept_up_to * gap_along(A, B, widest) ? *before : widest;
}

}  // namespace

GapManifold gap_manifold(const Part& A, const Part& B, const lin_canny::Proximity& near,
                         const std::optional<Vec3>& before) {
  GapManifold made{gap_normal(A, B, near, before), {}};
  Vec3& n = made.nhat_BA_W;
  const SupportingFace of_A = supporting_face(A.core, -n), of_B = supporting_face(B.core, n);
  const Vec3 normal_A = of_A.face >= 0 ? face_normal(A.core, of_A.face) : Vec3(Vec3::Zero());
  if (of_B.cosine > is_face_normal) {
    n = face_normal(B.core, of_B.face);
  } else if (of_A.cosine > is_face_normal) {
    n = -normal_A;
  }
  if (of_A.cosine > faces_oppose && of_B.cosine > faces_oppose) {
    made.points = common_corners(face_corners(A.core, of_A.face), normal_A, face_corners(B.core, of_B.face), n);
  }
  if (made.points.empty()) {
    const bool separated = near.verdict == Verdict::separated;
    const double gap = separated ? near.distance : gap_along(A, B, n);
    made.points = {{separated ? Vec3((near.p_WCa + near.p_WCb) / 2) : Vec3(near.p_WCa - gap / 2 * n), gap}};
  }
  return made;
}

}  // namespace touchstone::fast::contact
