// The exact penetration depth of two convex bodies: the least translation of A that leaves no common interior.
//
// For cores with common interior: depth = min over the facets of A − B of the distance of 0 to the facet's plane, plus
// r = rA + rB. Facet normals: faces of A, faces of B, and cross products of edges whose Gauss-map arcs cross.
// For cores apart at |d*| < r: depth = r − |d*|. Otherwise 0.
#pragma once

#include "model/answers.h"
#include "model/scene.h"
#include "reference/certificate.h"
#include "reference/rational.h"

namespace touchstone::reference {

struct PenetrationTruth {
  Verdict verdict = Verdict::separated;
  Rational core_squared;  ///< squared depth of the cores (overlapping cores), or |d*|² (cores apart)
  bool cores_overlap = false;
  Rational radius_sum;
  RationalVec3 direction;         ///< not normalised; A moves along it. Where several tie, one of them
  Interval depth;                 ///< tightest doubles around the depth; [0, 0] unless overlapping
  Vec3 nhat_BA_W = Vec3::Zero();  ///< direction, normalised in doubles
};

enum class DepthRoute {
  gauss_map,      ///< interval filter over the Gauss map's facets, exact survivors
  minkowski_hull  ///< hull of all vertex differences, least facet distance
};

/// Requires a completed scene; throws InputError for compounds (the depth of a union is another problem).
PenetrationTruth penetration(const Scene& scene, DepthRoute route = DepthRoute::gauss_map);

/// Is A, moved by `translation` (doubles, W), free of common interior with B? And by how much does it miss:
/// the exact depth that is left, 0 if none. For judging a claimed separating translation.
Interval depth_after(const Scene& scene, const Vec3& translation);

}  // namespace touchstone::reference
