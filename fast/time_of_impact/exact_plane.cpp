#include "fast/time_of_impact/exact_plane.h"

#include <span>

#include "fast/lin_canny/exact_proximity.h"

namespace touchstone::fast::time_of_impact {

namespace {

using exact::Vector;
using lin_canny::Hull;
using lin_canny::Kind;

/// Twice the normal of the triangle of a face's first corners, in or out. A hull's faces have no straight corners.
template <class Along>
Vector normal_of_face(const Hull& hull, int face, Along&& along) {
  const std::span<const Hull::Corner> corners = hull.corners(hull.face(face));
  return cross(along(corners[0].vertex, corners[1].vertex), along(corners[0].vertex, corners[2].vertex));
}

}  // namespace

bool separates_exactly(const lin_canny::Convex& A, const Pose& X_WA, const lin_canny::Convex& B, const Pose& X_WB,
                       const lin_canny::FeaturePair& along, const Vec3& from_B) {
  const lin_canny::ExactCore core_A(A, X_WA), core_B(B, X_WB);
  exact::Difference difference(core_A.points(), core_B.points());
  const auto along_A = [&](int v, int w) { return difference({v, 0}) - difference({w, 0}); };
  const auto along_B = [&](int v, int w) { return difference({0, w}) - difference({0, v}); };
  const auto normal = [&] {
    if (along.a.kind == Kind::face) return normal_of_face(A.core, along.a.index, along_A);
    if (along.b.kind == Kind::face) return normal_of_face(B.core, along.b.index, along_B);
    const Hull::Edge &a = A.core.edge(along.a.index), &b = B.core.edge(along.b.index);
    return cross(along_A(a.tail, a.head), along_B(b.tail, b.head));
  };
  Vector to_B = normal();
  if (to_B.is_zero()) return false;
  if (direction(to_B).dot(from_B) > 0) to_B = -to_B;
  return dot(to_B, difference(difference.support(to_B))).sign() >= 0;
}

}  // namespace touchstone::fast::time_of_impact
