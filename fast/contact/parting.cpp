#include "fast/contact/parting.h"

#include "fast/contact/support.h"
#include "fast/lin_canny/parting_normals.h"

namespace touchstone::fast::contact {
namespace {

constexpr double is_normal = 1 - 0x1p-41;  // cos 2⁻²⁰
constexpr double is_aligned = 0.9;         // cos 25°
constexpr double rounds = 0x1p-48;         // of the sizes
// Shares of the sizes: a longer connection has a direction beyond rounding, or even one so accurate that no corner is
// misplaced.
constexpr double has_direction = 0x1p-34;
constexpr double has_accurate_direction = 0x1p-16;

std::vector<Vec3> faces_within(const Part& A, const Part& B, const Vec3& n, double cosine) {
  std::vector<Vec3> normals;
  if (!B.is_ball()) normals.push_back(face_normal(B.core, supporting_face(B.core, n).face));
  if (!A.is_ball()) normals.push_back(-face_normal(A.core, supporting_face(A.core, -n).face));
  std::erase_if(normals, [&](const Vec3& normal) { return normal.dot(n) <= cosine; });
  return normals;
}

}  // namespace

double apart(const Part& A, const Part& B, const Vec3& n) {
  return lowest(A.core, n) + lowest(B.core, -n) - (A.convex->radius + B.convex->radius);
}

std::vector<double> clearances(const Part& A, const Part& B, const Vec3& n) {
  std::vector<double> all;
  const double low = lowest(A.core, n), high = -lowest(B.core, -n), radii = A.convex->radius + B.convex->radius;
  for (int v = 0; v < A.core.hull->vertex_count(); ++v) all.push_back(n.dot(A.core.vertex(v)) - high - radii);
  for (int v = 0; v < B.core.hull->vertex_count(); ++v) all.push_back(low - n.dot(B.core.vertex(v)) - radii);
  return all;
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

Vec3 parting(const Part& A, const lin_canny::CachedPose& X_WA, const Part& B, const lin_canny::CachedPose& X_WB) {
  if (A.is_ball() && B.is_ball()) return parting(A, B, {});
  lin_canny::FeaturePair memory;
  return parting(A, B, lin_canny::proximity(*A.convex, X_WA, *B.convex, X_WB, memory));
}

}  // namespace touchstone::fast::contact
