#include "fast/lin_canny/proximity.h"

#include <algorithm>

#include "fast/lin_canny/descent.h"
#include "fast/lin_canny/exact_proximity.h"
#include "fast/lin_canny/surround.h"
#include "fast/lin_canny/walk.h"

namespace touchstone::fast::lin_canny {
namespace {

/// Derives the answer for the parts (cores with radii) from the cores' bracket; returns false if it leaves the verdict
/// open.
bool decide(const Bracket& cores, double radius, Proximity& answer) {
  if (!is_explained_by_rounding(cores)) return false;
  const double lo = cores.lo - radius - 2 * u * (cores.lo + radius);
  const double hi = cores.hi - radius + 2 * u * (cores.hi + radius);
  if (lo > 0) {
    answer.verdict = Verdict::separated;
    answer.enclosure = {lo, hi};
    return true;
  }
  if (hi < 0) {  // two points of the cores are closer than the radii reach
    answer.verdict = Verdict::overlapping;
    return true;
  }
  return false;
}

/// What a decided bracket of the cores says of the parts.
void add_witnesses(const Bracket& cores, double radius_A, double radius_B, const Vec3& p_WO, Proximity& answer) {
  if (answer.verdict == Verdict::separated) {
    answer.distance = std::clamp(cores.length - (radius_A + radius_B), answer.enclosure.lo, answer.enclosure.hi);
  }
  const Vec3 n = cores.length > 0 ? Vec3((cores.b - cores.a) / cores.length) : Vec3(Vec3::Zero());
  answer.p_WCa = p_WO + (cores.a + radius_A * n);
  answer.p_WCb = p_WO + (cores.b - radius_B * n);
}

/// The descent multiplies up to four lengths of a simplex. These are as short as the distance of the cores, which may
/// be 2^-53 of their radii before it is rounding.
bool fit_descent(const Hull& hull) {
  return hull.radius() < 0x1p250 && (hull.radius() > 0x1p-200 || hull.vertex_count() == 1);
}

std::vector<exact::VertexPair> pairs_of(const Simplex& simplex) {
  std::vector<exact::VertexPair> pairs;
  for (int i = 0; i < simplex.size; ++i) {
    const VertexDifference& point = simplex.points[static_cast<std::size_t>(i)];
    pairs.push_back({point.a, point.b});
  }
  return pairs;
}

void prefetch_vertex(const Hull& hull, int v) {
  __builtin_prefetch(&hull.vertex(v));
  for (const Hull::Spokes& some : hull.spokes(v)) __builtin_prefetch(&some);
}

/// What the first step and the bracket read of a hull is asked for before it is needed: of many pairs in turn, it is in
/// memory.
void prefetch_feature(const Hull& hull, const FeatureId& feature) {
  if (feature.kind == Kind::vertex) prefetch_vertex(hull, feature.index);
  if (feature.kind == Kind::edge) {
    prefetch_vertex(hull, hull.edge(feature.index).tail);
    prefetch_vertex(hull, hull.edge(feature.index).head);
  }
  if (feature.kind == Kind::face) {
    for (const auto& corner : hull.corners(hull.face(feature.index))) __builtin_prefetch(&hull.vertex(corner.vertex));
  }
}

}  // namespace

Distance as_distance(const Proximity& found) {
  Distance answer;
  answer.verdict = found.verdict;
  answer.distance = found.distance;
  answer.enclosure = found.enclosure;
  answer.p_WCa = found.p_WCa;
  answer.p_WCb = found.p_WCb;
  return answer;
}

Proximity proximity(const Convex& A, const CachedPose& body_A, const Convex& B, const CachedPose& body_B,
                    FeaturePair& memory) {
  prefetch_feature(A.core, memory.a);
  prefetch_feature(B.core, memory.b);
  const Vec3& p_WO = body_A.X_WB.p_WB;
  const PosedHull placed_A = posed_hull(A, body_A, p_WO);
  const PosedHull placed_B = posed_hull(B, body_B, p_WO);
  if (!fit_doubles(placed_A, placed_B)) return exact_proximity(A, body_A, B, body_B, memory);
  if (memory == FeaturePair{}) memory = facing_features(placed_A, placed_B);
  const Walked walked = walk(placed_A, placed_B, memory);
  memory = walked.closest.features;
  Proximity answer;
  answer.features = memory;
  Bracket cores;
  if (!walked.inside) cores = bracket(placed_A, placed_B, walked.closest);
  if (walked.inside || !decide(cores, A.radius + B.radius, answer)) {
    const std::optional<Vec3> common = common_point(placed_A, placed_B);
    if (!common) return exact_proximity(A, body_A, B, body_B, memory);
    answer.verdict = Verdict::overlapping;
    answer.p_WCa = answer.p_WCb = p_WO + *common;
    return answer;
  }
  add_witnesses(cores, A.radius, B.radius, p_WO, answer);
  return answer;
}

Proximity proximity(const Convex& A, const CachedPose& body_A, const Convex& B, const CachedPose& body_B) {
  const Vec3& p_WO = body_A.X_WB.p_WB;
  const PosedHull placed_A = posed_hull(A, body_A, p_WO);
  const PosedHull placed_B = posed_hull(B, body_B, p_WO);
  const bool fit = fit_descent(A.core) && fit_descent(B.core) && fit_doubles(placed_A, placed_B);
  if (!fit) return exact_proximity(A, body_A, B, body_B, std::vector<exact::VertexPair>{{0, 0}});
  const double error = rounding(placed_A, placed_B);
  const Simplex nearest = descend(placed_A, placed_B, error);
  Proximity answer;
  if (nearest.size == 4) {
    const std::optional<Vec3> common = common_point(nearest, error);
    if (!common) return exact_proximity(A, body_A, B, body_B, pairs_of(nearest));
    answer.verdict = Verdict::overlapping;
    answer.p_WCa = answer.p_WCb = p_WO + *common;
    return answer;
  }
  const Bracket cores = bracket(placed_A, placed_B, nearest, error);
  if (!decide(cores, A.radius + B.radius, answer)) {
    return exact_proximity(A, body_A, B, body_B, pairs_of(nearest));
  }
  if (answer.verdict == Verdict::separated) {
    answer.closest_vertices_A = closest_vertices(placed_A, cores.n, nearest, &VertexDifference::a);
    answer.closest_vertices_B = closest_vertices(placed_B, -cores.n, nearest, &VertexDifference::b);
  }
  add_witnesses(cores, A.radius, B.radius, p_WO, answer);
  return answer;
}

}  // namespace touchstone::fast::lin_canny
