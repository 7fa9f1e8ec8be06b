#include "fast/time_of_impact/common_middle.h"

#include <algorithm>
#include <vector>

namespace touchstone::fast::meeting {

using lin_canny::Hull;
using lin_canny::Placed;

namespace {

struct Segment {
  Vec3 from, to;
};

/// What all P's edges leave in Q.
std::vector<Segment> left_in(const Placed& Q, const Placed& P) {
  const std::size_t faces = static_cast<std::size_t>(Q.hull->face_count());
  std::vector<Vec3> places;
  std::vector<double> heights;  // of each vertex over each of Q's faces
  places.reserve(P.hull->vertices().size());
  heights.reserve(P.hull->vertices().size() * faces);
  for (const Vec3& v : P.hull->vertices()) {
    places.push_back(Q.in(P.out(v)));
    for (int f = 0; f < Q.hull->face_count(); ++f) {
      heights.push_back(Q.hull->face(f).normal.dot(places.back()) - Q.hull->face(f).height);
    }
  }
  std::vector<Segment> found;
  for (int e = 0; e < P.hull->edge_count(); ++e) {
    const std::size_t i = static_cast<std::size_t>(P.hull->edge(e).tail);
    const std::size_t j = static_cast<std::size_t>(P.hull->edge(e).head);
    const Vec3 &tail = places[i], &head = places[j];
    double from = 0, to = 1;
    for (std::size_t f = 0; f < faces && from <= to; ++f) {
      const double at_tail = heights[i * faces + f], at_head = heights[j * faces + f];
      if (at_tail > 0 && at_head > 0) to = -1;
      if (at_tail > 0 && at_head <= 0) from = std::max(from, at_tail / (at_tail - at_head));
      if (at_tail <= 0 && at_head > 0) to = std::min(to, at_tail / (at_tail - at_head));
    }
    if (from <= to) found.push_back({Q.out(tail + from * (head - tail)), Q.out(tail + to * (head - tail))});
  }
  return found;
}

Vec3 middle(const Segment& segment) { return (segment.from + segment.to) / 2; }

}  // namespace

bool is_inside(const Placed& P, const Vec3& p, double error) {
  const Vec3 x = P.in(p);
  for (int f = 0; f < P.hull->face_count(); ++f) {
    const Hull::Face& face = P.hull->face(f);
    if (!(face.normal.dot(x) < face.height - error)) return false;
  }
  return P.hull->face_count() > 0;
}

bool share_a_middle(const Placed& A, const Placed& B, double error) {
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

}  // namespace touchstone::fast::meeting
