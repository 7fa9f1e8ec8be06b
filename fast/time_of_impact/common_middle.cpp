#include "fast/time_of_impact/common_middle.h"

#include <algorithm>
#include <vector>

namespace touchstone::fast::time_of_impact {

using lin_canny::Hull;
using lin_canny::PosedHull;

namespace {

struct Segment {
  Vec3 from, to;
};

/// The parts of all of P's edges that lie in Q. The face that excluded the last edge is tested first: it excludes most
/// edges.
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
    for (int i = 0; i < faces && from <= to; ++i) {
      const int f = first + i < faces ? first + i : first + i - faces;
      const Hull::Face& face = Q.hull->face(f);
      const double at_tail = face.normal.dot(tail) - face.height, at_head = face.normal.dot(head) - face.height;
      if (at_tail > 0 && at_head > 0) to = -1, first = f;
      if (at_tail > 0 && at_head <= 0) from = std::max(from, at_tail / (at_tail - at_head));
      if (at_tail <= 0 && at_head > 0) to = std::min(to, at_tail / (at_tail - at_head));
    }
    if (from <= to) found.push_back({Q.out(tail + from * (head - tail)), Q.out(tail + to * (head - tail))});
  }
  return found;
}

Vec3 middle(const Segment& segment) { return (segment.from + segment.to) / 2; }

}  // namespace

bool is_inside(const PosedHull& P, const Vec3& p, double error) {
  const Vec3 x = P.in(p);
  for (int f = 0; f < P.hull->face_count(); ++f) {
    const Hull::Face& face = P.hull->face(f);
    if (!(face.normal.dot(x) < face.height - error)) return false;
  }
  return P.hull->face_count() > 0;
}

bool share_a_middle(const PosedHull& A, const PosedHull& B, double error) {
  if (A.hull->face_count() == 0 || B.hull->face_count() == 0) return false;
  const std::vector<Segment> of_A = left_in(B, A), of_B = left_in(A, B);
  if (std::ranges::any_of(of_A, [&](const Segment& s) { return is_inside(B, middle(s), error); })) return true;
  if (std::ranges::any_of(of_B, [&](const Segment& s) { return is_inside(A, middle(s), error); })) return true;
  if (of_A.empty() && of_B.empty()) return false;
  Vec3 sum = Vec3::Zero();
  for (const Segment& s : of_A) sum += middle(s);
  for (const Segment& s : of_B) sum += middle(s);
  const Vec3 mean = sum / static_cast<double>(of_A.size() + of_B.size());
  return is_inside(A, mean, error) && is_inside(B, mean, error);
}

}  // namespace touchstone::fast::time_of_impact
