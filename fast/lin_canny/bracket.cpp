#include "fast/lin_canny/bracket.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>

#include "fast/lin_canny/facing.h"
#include "fast/mark.h"

namespace touchstone::fast::lin_canny {
namespace {

/// max n·x over the hull; `own`: n is the normal of the face that the feature is.
double height(const PosedHull& P, const FeatureId& feature, const Vec3& n, bool own) {
  const Hull& hull = *P.hull;
  if (feature.kind == Kind::face && own) return hull.face(feature.index).height;
  const FloatDirection direction(n);
  if (feature.kind == Kind::vertex && direction.lead_down(hull.spokes(feature.index))) {
    return n.dot(hull.vertex(feature.index));
  }
  if (feature.kind == Kind::edge) {
    const Hull::Edge& e = hull.edge(feature.index);
    if (direction.lead_down(hull.spokes(e.tail), e.head) && direction.lead_down(hull.spokes(e.head), e.tail)) {
      return std::max(n.dot(hull.vertex(e.tail)), n.dot(hull.vertex(e.head)));
    }
  }
  mark(Mark::face_scan);
  return greatest_height(hull, n);
}

/// v without its component along e.
Vec3 across(const Vec3& v, const Vec3& e) { return v - e * (v.dot(e) / e.squaredNorm()); }

Vec3 along_difference(const Vec3& n, const Vec3& d) { return n.dot(d) < 0 ? Vec3(-n) : n; }

/// From A to B, of any length.
Vec3 direction(const PosedHull& A, const PosedHull& B, const Closest& c) {
  const auto& [a, b] = c.features;
  const Vec3 d = c.b - c.a;
  if (a.kind == Kind::edge && b.kind == Kind::edge) {
    const Vec3 along_A = A.hull->along(A.hull->edge(a.index)), along_B = B.hull->along(B.hull->edge(b.index));
    const Vec3 e = A.turned_out(along_A), f = B.turned_out(along_B);
    const Vec3 n = (e / along_A.norm()).cross(f / along_B.norm());
    return n.squaredNorm() > clearly_crossing ? along_difference(n, d) : across(across(d, e), f);
  }
  if (a.kind == Kind::edge) return across(d, A.edge_vector(a.index));
  if (b.kind == Kind::edge) return across(d, B.edge_vector(b.index));
  return d;
}

double lower_end(const PosedHull& A, const PosedHull& B, const FeaturePair& features, const Vec3& n, double error) {
  const bool own_a = features.a.kind == Kind::face;
  const bool own_b = features.b.kind == Kind::face;
  const double up_to_A = height(A, features.a, own_a ? A.hull->face(features.a.index).normal : A.turned_in(n), own_a);
  const double up_to_B = height(B, features.b, own_b ? B.hull->face(features.b.index).normal : B.turned_in(-n), own_b);
  return gap_between(A, B, n, up_to_A, up_to_B, error);
}

/// A point of a face near x (both in the hull's frame), as a convex combination of three corners of its triangle fan.
Vec3 into_face(const Hull& hull, int f, const Vec3& x) {
  const Hull::Face& face = hull.face(f);
  const std::span<const Hull::Corner> corners = hull.corners(face);
  const auto corner = [&](std::size_t i) -> const Vec3& { return hull.vertex(corners[i].vertex); };
  const Vec3& o = corner(0);
  const auto turn = [&](const Vec3& from, const Vec3& to) { return (from - o).cross(to - o).dot(face.normal); };
  std::size_t k = 2;
  while (k + 1 < corners.size() && turn(x, corner(k)) < 0) ++k;
  const Vec3& p = corner(k - 1);
  const Vec3& q = corner(k);
  const double whole = turn(p, q);
  const double at_p = std::clamp(turn(x, q) / whole, 0.0, 1.0);
  const double at_q = std::clamp(turn(p, x) / whole, 0.0, 1 - at_p);
  return o + (at_p * (p - o) + at_q * (q - o));
}

Vec3 witness(const PosedHull& P, const FeatureId& feature, const Vec3& p) {
  return feature.kind == Kind::face ? P.out(into_face(*P.hull, feature.index, P.in(p))) : p;
}

}  // namespace

double rounding(const PosedHull& A, const PosedHull& B) {
  const double reach = (A.turn_error + 7 * u) * A.hull->radius() + (B.turn_error + 7 * u) * B.hull->radius();
  return reach + 8 * u * (B.t - A.t).norm() + A.shift_error + B.shift_error + 0x1p-900;
}

double gap_between(const PosedHull& A, const PosedHull& B, const Vec3& n, double up_to_A, double up_to_B,
                   double rounding_error) {
  const double gap = n.dot(B.t - A.t) - up_to_A - up_to_B - rounding_error;
  return std::max(0.0, gap * (1 - 4 * u));
}

double error_of_hi(const PosedHull& A, const PosedHull& B, double rounding_error) {
  return rounding_error + 7 * u * (A.hull->radius() + B.hull->radius()) - 6 * u * (B.t - A.t).norm();
}

Vec3 separating_direction(const PosedHull& A, const PosedHull& B, const Closest& c) {
  if (c.features.a.kind == Kind::face) return A.turned_out(A.hull->face(c.features.a.index).normal);
  if (c.features.b.kind == Kind::face) return -B.turned_out(B.hull->face(c.features.b.index).normal);
  const Vec3 n = direction(A, B, c);
  const double length = n.norm();
  return length > 0 ? Vec3(n / length) : Vec3(Vec3::Zero());
}

Bracket bracket(const PosedHull& A, const PosedHull& B, const Closest& c) {
  const double error = rounding(A, B);
  Bracket found;
  found.rounding = error;
  found.a = witness(A, c.features.a, c.a);
  found.b = witness(B, c.features.b, c.b);
  found.length = (found.b - found.a).norm();
  found.hi = found.length * (1 + 4 * u) + error_of_hi(A, B, error);
  found.n = separating_direction(A, B, c);
  if (found.n.isZero(0)) return found;
  found.lo = lower_end(A, B, c.features, found.n, error);
  return found;
}

}  // namespace touchstone::fast::lin_canny
