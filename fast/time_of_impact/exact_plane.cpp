#include "fast/time_of_impact/exact_plane.h"

#include <span>

namespace touchstone::fast::time_of_impact {

using exact::Vector;
using lin_canny::FeaturePair;
using lin_canny::Hull;
using lin_canny::Kind;

namespace {

/// Twice the normal of the triangle of a face's first corners, in or out. A hull's faces have no straight corners.
template <class Along>
Vector normal_of_face(const Hull& hull, int face, Along&& along) {
  const std::span<const Hull::Corner> corners = hull.corners(hull.face(face));
  return cross(along(corners[0].vertex, corners[1].vertex), along(corners[0].vertex, corners[2].vertex));
}

}  // namespace

bool separates_exactly(const Hull& hull_A, const exact::PosedPoints& A, const Hull& hull_B, const exact::PosedPoints& B,
                       const FeaturePair& along, const Vec3& from_B) {
  exact::Difference difference(A, B);
  const auto along_A = [&](int v, int w) { return difference({v, 0}) - difference({w, 0}); };
  const auto along_B = [&](int v, int w) { return difference({0, w}) - difference({0, v}); };
  const auto normal = [&] {
    if (along.a.kind == Kind::face) return normal_of_face(hull_A, along.a.index, along_A);
    if (along.b.kind == Kind::face) return normal_of_face(hull_B, along.b.index, along_B);
    const Hull::Edge &a = hull_A.edge(along.a.index), &b = hull_B.edge(along.b.index);
    return cross(along_A(a.tail, a.head), along_B(b.tail, b.head));
  };
  Vector to_B = normal();
  if (to_B.is_zero()) return false;
  if (direction(to_B).dot(from_B) > 0) to_B = -to_B;
  return dot(to_B, difference(difference.support(to_B))).sign() >= 0;
}

}  // namespace touchstone::fast::time_of_impact
