#include "fast/lin_canny/exact_proximity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>

#include "fast/exact/nearest.h"
#include "fast/mark.h"
#include "model/infinity.h"

namespace touchstone::fast::lin_canny {
namespace {

using exact::Dyadic;
using exact::VertexPair;

int some_vertex(const Hull& hull, const FeatureId& f, int which) {
  if (f.kind == Kind::vertex) return f.index;
  if (f.kind == Kind::edge) return which % 2 == 0 ? hull.edge(f.index).tail : hull.edge(f.index).head;
  const std::span<const Hull::Corner> corners = hull.corners(hull.face(f.index));
  return corners[static_cast<std::size_t>(which) % corners.size()].vertex;
}

/// Up to three pairs that include each vertex of a feature, or three of a face's.
std::vector<VertexPair> first_pairs(const Hull& A, const Hull& B, const FeaturePair& guess) {
  std::vector<VertexPair> pairs;
  for (int i = 0; i < 3; ++i) {
    const bool edges_crosswise = i == 2 && guess.a.kind == Kind::edge && guess.b.kind == Kind::edge;
    const VertexPair pair{some_vertex(A, guess.a, i), some_vertex(B, guess.b, edges_crosswise ? 1 : i)};
    if (std::ranges::find(pairs, pair) == pairs.end()) pairs.push_back(pair);
  }
  return pairs;
}

double over(const Dyadic::Scientific& x, double y) {
  int exponent = 0;
  const double m = std::frexp(y, &exponent);
  return exact::approximate({x.m / m, x.exponent - exponent});
}

/// An interval around a value with a relative error of a few 2^-52.
Interval around(double x) {
  const double lo = x * (1 - 0x1p-48);
  const double hi = x * (1 + 0x1p-48);
  return {std::max(0.0, std::nextafter(lo, 0.0)), std::nextafter(hi, infinity)};
}

std::vector<int> distinct(const std::vector<VertexPair>& pairs, int VertexPair::*side) {
  std::vector<int> vertices;
  for (const VertexPair& pair : pairs) vertices.push_back(pair.*side);
  std::ranges::sort(vertices);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

/// Σ weights · vertices / Σ weights, in the core's own frame.
Vec3 combined(const Hull& hull, const exact::Nearest& found, int VertexPair::*side) {
  Dyadic sum = 0;
  for (const Dyadic& w : found.weights) sum = sum + w;
  Vec3 x = Vec3::Zero();
  for (std::size_t i = 0; i < found.pairs.size(); ++i) {
    x += exact::ratio(found.weights[i], sum) * hull.vertex(found.pairs[i].*side);
  }
  return x;
}

Vec3 in_world(const Convex& part, const CachedPose& body, const Vec3& x) {
  const Vec3 p = part.is_posed ? Vec3(part.R_BP * x + part.X_BP.p_WB) : x;
  return body.R_WB * p + body.X_WB.p_WB;
}

}  // namespace

Proximity exact_proximity(const Convex& A, const CachedPose& body_A, const Convex& B, const CachedPose& body_B,
                          const FeaturePair& guess) {
  Proximity answer = exact_proximity(A, body_A, B, body_B, first_pairs(A.core, B.core, guess));
  answer.features = guess;
  return answer;
}

Proximity exact_proximity(const Convex& A, const CachedPose& body_A, const Convex& B, const CachedPose& body_B,
                          const std::vector<VertexPair>& guess) {
  mark(Mark::exact_proximity);
  const ExactCore core_A(A, body_A.X_WB), core_B(B, body_B.X_WB);
  exact::Difference difference(core_A.points(), core_B.points());
  const exact::Nearest found = exact::nearest(difference, guess);

  Proximity answer;
  answer.closest_vertices_A = distinct(found.pairs, &VertexPair::a);
  answer.closest_vertices_B = distinct(found.pairs, &VertexPair::b);
  answer.p_WCa = in_world(A, body_A, combined(A.core, found, &VertexPair::a));
  answer.p_WCb = in_world(B, body_B, combined(B.core, found, &VertexPair::b));

  const Dyadic radius = Dyadic(A.radius) + Dyadic(B.radius);
  answer.verdict = found.verdict;
  if (found.verdict != Verdict::separated) {
    if (radius.sign() > 0) answer.verdict = Verdict::overlapping;
    return answer;
  }
  // distance = (|d*|² − r²)/(|d*| + r), whose numerator is exact: no cancellation.
  const Dyadic D = difference.denominator();
  const Dyadic square_over = found.squared_over * D * D;
  const Dyadic above = found.squared_times - radius * radius * square_over;
  answer.verdict = above.sign() > 0 ? Verdict::separated : above.sign() == 0 ? Verdict::touching : Verdict::overlapping;
  const Vec3 n = exact::direction(found.normal).normalized();
  answer.p_WCa += A.radius * n;
  answer.p_WCb -= B.radius * n;
  if (answer.verdict != Verdict::separated) return answer;
  const double core_distance = exact::root_of_ratio(found.squared_times, square_over);
  const double distance = radius.sign() == 0
                              ? core_distance
                              : over(exact::quotient(above, square_over), core_distance + radius.approximate());
  if (!std::isfinite(distance) || !std::isfinite(core_distance)) {
    throw std::range_error("the distance is beyond the range of doubles");
  }
  answer.distance = std::max(distance, std::numeric_limits<double>::denorm_min());
  answer.enclosure = around(distance);
  return answer;
}

}  // namespace touchstone::fast::lin_canny
