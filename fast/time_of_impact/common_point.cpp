#include "fast/time_of_impact/common_point.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

namespace touchstone::fast::time_of_impact {

using lin_canny::Hull;
using lin_canny::PosedHull;

namespace {

/// The part of an edge of P that lies in Q, in the pair's frame.
struct Segment {
  Vec3 from, to;
  Vec3 tail, head;                    ///< the whole edge, in Q's frame
  int entered_by = -1, left_by = -1;  ///< faces of Q; none: the part ends with the edge
};

/// Of all of P's edges. The face that excluded the last edge is tested first: it excludes most edges.
std::vector<Segment> left_in(const PosedHull& Q, const PosedHull& P) {
  std::vector<Vec3> places;
  places.reserve(P.hull->vertices().size());
  for (const Vec3& v : P.hull->vertices()) places.push_back(Q.in(P.out(v)));
  std::vector<Segment> found;
  const int faces = Q.hull->face_count();
  int first = 0;
  for (int e = 0; e < P.hull->edge_count(); ++e) {
    const Vec3& tail = places[static_cast<std::size_t>(P.hull->edge(e).tail)];
    const Vec3& head = places[static_cast<std::size_t>(P.hull->edge(e).head)];
    double from = 0, to = 1;
    int entered_by = -1, left_by = -1;
    for (int i = 0; i < faces && from <= to; ++i) {
      const int f = first + i < faces ? first + i : first + i - faces;
      const Hull::Face& face = Q.hull->face(f);
      const double at_tail = face.normal.dot(tail) - face.height, at_head = face.normal.dot(head) - face.height;
      if (at_tail > 0 && at_head > 0) to = -1, first = f;
      if ((at_tail > 0) == (at_head > 0)) continue;
      const double crossed = at_tail / (at_tail - at_head);
      if (at_tail > 0 && crossed > from) from = crossed, entered_by = f;
      if (at_head > 0 && crossed < to) to = crossed, left_by = f;
    }
    if (from <= to) {
      const Vec3 way = head - tail;
      found.push_back({Q.out(tail + from * way), Q.out(tail + to * way), tail, head, entered_by, left_by});
    }
  }
  return found;
}

Vec3 middle(const Segment& segment) { return (segment.from + segment.to) / 2; }

/// Whether an edge, in the hull's frame with its ends known within `error`, surely crosses a face. Its exact point in
/// the face's plane is within error (1 + 2 L/d) of the computed one, where L is its length and d the difference of its
/// ends' heights.
bool crosses(const Hull& hull, int f, const Vec3& tail, const Vec3& head, double error) {
  if (f < 0) return false;
  const Hull::Face& face = hull.face(f);
  const double at_tail = face.normal.dot(tail) - face.height, at_head = face.normal.dot(head) - face.height;
  if (!(std::min(std::abs(at_tail), std::abs(at_head)) > error)) return false;
  const Vec3 way = head - tail, x = tail + at_tail / (at_tail - at_head) * way;
  const double uncertain = 2 * error * (1 + way.norm() / std::abs(at_tail - at_head));
  const auto corners = hull.corners(face);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec3& v = hull.vertex(corners[k].vertex);
    const Vec3 side = hull.vertex(corners[(k + 1) % corners.size()].vertex) - v;
    if (!(face.normal.cross(side).dot(x - v) > uncertain * side.norm())) return false;
  }
  return true;
}

bool crosses(const Hull& hull, const Segment& s, double error) {
  return crosses(hull, s.entered_by, s.tail, s.head, error) || crosses(hull, s.left_by, s.tail, s.head, error);
}

}  // namespace

bool is_inside(const PosedHull& P, const Vec3& p, double error) {
  const Vec3 x = P.in(p);
  for (int f = 0; f < P.hull->face_count(); ++f) {
    const Hull::Face& face = P.hull->face(f);
    if (!(face.normal.dot(x) < face.height - error)) return false;
  }
  return P.hull->face_count() > 0;
}

bool share_a_point(const PosedHull& A, const PosedHull& B, double error) {
  if (A.hull->face_count() == 0 || B.hull->face_count() == 0) return false;
  const std::vector<Segment> of_A = left_in(B, A), of_B = left_in(A, B);
  if (std::ranges::any_of(of_A, [&](const Segment& s) { return is_inside(B, middle(s), error); })) return true;
  if (std::ranges::any_of(of_B, [&](const Segment& s) { return is_inside(A, middle(s), error); })) return true;
  if (std::ranges::any_of(of_A, [&](const Segment& s) { return crosses(*B.hull, s, error); })) return true;
  if (std::ranges::any_of(of_B, [&](const Segment& s) { return crosses(*A.hull, s, error); })) return true;
  if (of_A.empty() && of_B.empty()) return false;
  Vec3 sum = Vec3::Zero();
  for (const Segment& s : of_A) sum += middle(s);
  for (const Segment& s : of_B) sum += middle(s);
  const Vec3 mean = sum / static_cast<double>(of_A.size() + of_B.size());
  return is_inside(A, mean, error) && is_inside(B, mean, error);
}

}  // namespace touchstone::fast::time_of_impact
