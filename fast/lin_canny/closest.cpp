#include "fast/lin_canny/closest.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "model/infinity.h"

namespace touchstone::fast::lin_canny {
namespace {

FeatureId vertex(int v) { return {Kind::vertex, v}; }
FeatureId edge(int e) { return {Kind::edge, e}; }
FeatureId face(int f) { return {Kind::face, f}; }

Closest measured(const FeaturePair& features, const Vec3& a, const Vec3& b) {
  return {features, a, b, (b - a).squaredNorm(), false};
}

Closest none() {
  Closest c;
  c.squared = infinity;
  return c;
}

void take_nearer(Closest& best, const Closest& other) {
  if (other.squared < best.squared) best = other;
}

/// A point of an edge at tail + s·along, and the lowest-dimensional feature that contains it. `tail` and `along` are in
/// the pair's frame.
struct OnEdge {
  FeatureId feature;
  Vec3 at;
};

OnEdge on_edge(const PosedHull& P, int e, const Vec3& tail, const Vec3& along, double s) {
  if (!(s > 0)) return {vertex(P.hull->edge(e).tail), tail};
  if (s >= 1) return {vertex(P.hull->edge(e).head), P.vertex(P.hull->edge(e).head)};
  return {edge(e), tail + s * along};
}

Closest vertex_vertex(const PosedHull& A, int v, const PosedHull& B, int w) {
  return measured({vertex(v), vertex(w)}, A.vertex(v), B.vertex(w));
}

Closest point_edge(const FeatureId& feature, const Vec3& p, const PosedHull& B, int e) {
  const Hull::Edge& ends = B.hull->edge(e);
  const Vec3 tail = B.vertex(ends.tail);
  const Vec3 in_B = B.hull->along(ends);
  const Vec3 along = B.turned_out(in_B);
  const OnEdge on = on_edge(B, e, tail, along, (p - tail).dot(along) / in_B.squaredNorm());
  return measured({feature, on.feature}, p, on.at);
}

/// The sides of a face as lines in its plane.
class Sides {
 public:
  Sides(const Hull& hull, const Hull::Face& face) : hull_(hull), normal_(face.normal), corners_(hull.corners(face)) {}

  std::size_t count() const { return corners_.size(); }
  int edge(std::size_t i) const { return corners_[i].side; }

  /// Height above a side's line in the face's plane, outward of the face: > 0 outside. Measured from the edge's tail,
  /// as from its other face.
  double outside(std::size_t i, const Vec3& x) const {
    const int v = corners_[i].vertex, w = corners_[i + 1 < corners_.size() ? i + 1 : 0].vertex;
    return (hull_.vertex(w) - hull_.vertex(v)).cross(normal_).dot(x - hull_.vertex(std::min(v, w)));
  }

 private:
  const Hull& hull_;
  const Vec3& normal_;
  std::span<const Hull::Corner> corners_;
};

Closest vertex_face(const PosedHull& A, int v, const PosedHull& B, int f) {
  const Vec3 p = A.vertex(v);
  const Vec3 x = B.in(p);
  const Hull& hull = *B.hull;
  const Hull::Face& plane = hull.face(f);
  const Sides sides(hull, plane);
  Closest best = none();
  bool over = true;
  for (std::size_t i = 0; i < sides.count(); ++i) {
    if (!(sides.outside(i, x) > 0)) continue;
    over = false;
    take_nearer(best, point_edge(vertex(v), p, B, sides.edge(i)));
  }
  if (!over) return best;
  const double height = plane.normal.dot(x) - plane.height;
  Closest c = measured({vertex(v), face(f)}, p, p - B.turned_out(plane.normal * height));
  c.below = !(height > 0);
  return c;
}

/// The s of the point of the line p + s d that is nearest to the line q + r g, w = q − p: s|d × g|² = (w × g)·(d × g).
/// The cross product of directions that round by turn_error is right to 2^-47 of |d||g|; what is below 2^-46 is mostly
/// rounding, and any s will do.
double of_nearly_parallel(const Vec3& d, const Vec3& g, const Vec3& w) {
  constexpr double parallel = 0x1p-92;
  const Vec3 across = d.cross(g);
  const double square = across.squaredNorm();
  return square > parallel * d.squaredNorm() * g.squaredNorm() ? w.cross(g).dot(across) / square : 0;
}

/// On lines p + s d and q + r e the closest points have s|d|² − r d·e = d·w and s d·e − r|e|² = e·w with w = q − p;
/// clamped to the edges one after the other. (For parallel edges any s will do; r follows from it.)
Closest edge_edge(const PosedHull& A, int e, const PosedHull& B, int f) {
  const Hull::Edge& edge_A = A.hull->edge(e);
  const Hull::Edge& edge_B = B.hull->edge(f);
  const Vec3 along_A = A.hull->along(edge_A);
  const Vec3 along_B = B.hull->along(edge_B);
  const Vec3 d = A.turned_out(along_A);
  const Vec3 g = B.turned_out(along_B);
  const Vec3 p = A.vertex(edge_A.tail);
  const Vec3 q = B.vertex(edge_B.tail);
  const Vec3 w = q - p;
  const double dd = along_A.squaredNorm();
  const double gg = along_B.squaredNorm();
  const double dg = d.dot(g);
  const double dw = d.dot(w);
  const double gw = g.dot(w);
  const double sine = dd * gg - dg * dg;
  // The squared sine. d and g round by at most turn_error each and dd·gg and dg² by a few u more: together less than
  // 2^-46 of dd·gg.
  constexpr double nearly_parallel = 0x1p-20;
  double s = sine > nearly_parallel * dd * gg ? (gg * dw - dg * gw) / sine : of_nearly_parallel(d, g, w);
  s = std::clamp(s, 0.0, 1.0);
  const double r = std::clamp((s * dg - gw) / gg, 0.0, 1.0);
  s = std::clamp((r * dg + dw) / dd, 0.0, 1.0);
  const OnEdge a = on_edge(A, e, p, d, s);
  const OnEdge b = on_edge(B, f, q, g, r);
  return measured({a.feature, b.feature}, a.at, b.at);
}

/// The nearest point of the edge is an end of it over the face, or it is beside the face, or where the edge leaves it.
/// In the last two cases the nearest point of the face is on a side beyond which at least part of the edge lies.
Closest edge_face(const PosedHull& A, int e, const PosedHull& B, int f) {
  const Hull::Edge& ends = A.hull->edge(e);
  const Hull& hull = *B.hull;
  const Hull::Face& plane = hull.face(f);
  const Vec3 tail = B.in(A.vertex(ends.tail));
  const Vec3 head = B.in(A.vertex(ends.head));
  Closest best = none();
  double from = 0;  // tail + s·along is over the face for s in [from, to]
  double to = 1;
  const Sides sides(hull, plane);
  for (std::size_t i = 0; i < sides.count(); ++i) {
    const double at_tail = sides.outside(i, tail);
    const double at_head = sides.outside(i, head);
    if (!(at_tail > 0) && !(at_head > 0)) continue;
    take_nearer(best, edge_edge(A, e, B, sides.edge(i)));
    if (at_tail > 0) from = std::max(from, at_head > 0 ? 2.0 : at_tail / (at_tail - at_head));
    if (at_head > 0) to = std::min(to, at_tail > 0 ? -1.0 : at_tail / (at_tail - at_head));
  }
  if (!(from <= to)) return best;
  const double low = plane.normal.dot(tail) - plane.height;
  const double rise = plane.normal.dot(head - tail);
  const double at_from = low + from * rise;
  const double at_to = low + to * rise;
  if (!(at_from > 0) || !(at_to > 0)) {
    Closest c;
    c.features = {vertex(at_from < at_to ? ends.tail : ends.head), face(f)};
    c.below = true;
    return c;
  }
  if (from == 0) take_nearer(best, vertex_face(A, ends.tail, B, f));
  if (to == 1) take_nearer(best, vertex_face(A, ends.head, B, f));
  return best;
}

/// Only a place to start from: a corner of one face against the other face.
Closest face_face(const PosedHull& A, int f, const PosedHull& B, int g) {
  return vertex_face(A, A.hull->corners(A.hull->face(f))[0].vertex, B, g);
}

/// Requires that a feature of A has no more dimensions than that of B.
Closest in_order(const PosedHull& A, const PosedHull& B, const FeaturePair& features) {
  const auto& [a, b] = features;
  if (a.kind == Kind::vertex) {
    if (b.kind == Kind::vertex) return vertex_vertex(A, a.index, B, b.index);
    if (b.kind == Kind::edge) return point_edge(a, A.vertex(a.index), B, b.index);
    return vertex_face(A, a.index, B, b.index);
  }
  if (a.kind == Kind::face) return face_face(A, a.index, B, b.index);
  if (b.kind == Kind::edge) return edge_edge(A, a.index, B, b.index);
  return edge_face(A, a.index, B, b.index);
}

}  // namespace

Closest closest(const PosedHull& A, const PosedHull& B, const FeaturePair& features) {
  const auto& [a, b] = features;
  if (a.kind <= b.kind) return in_order(A, B, features);
  Closest found = in_order(B, A, {b, a});
  std::swap(found.features.a, found.features.b);
  std::swap(found.a, found.b);
  return found;
}

}  // namespace touchstone::fast::lin_canny
