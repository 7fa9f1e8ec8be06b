// The exact penetration depth of two convex bodies: the least translation of A that leaves no common interior.
//
// Cores with common interior: depth = min over the facets of A − B of the distance of 0 to the facet's plane, plus r =
// rA + rB. The facet normals are those of the faces of A, of the faces of B, and the cross products of edges whose
// Gauss-map arcs cross.
// Cores apart with |d*| < r: depth = r − |d*|. Otherwise 0.
#pragma once

#include "model/answers.h"
#include "model/scene.h"
#include "reference/certificate.h"
#include "reference/rational.h"

namespace touchstone::reference {

/// The depth of bodies 0 (A) and 1 (B), and a direction in which A leaves B; lengths in m, directions in W.
struct PenetrationTruth {
  Verdict verdict = Verdict::separated;
  Rational core_squared;  ///< squared depth of the cores (cores overlap), or |d*|² (cores apart)
  bool cores_overlap = false;
  Rational radius_sum;
  RationalVec3 direction;         ///< not normalised; A moves along it. One of several, if they tie
  Interval depth;                 ///< tightest doubles around the depth; [0, 0] unless overlapping
  Vec3 nhat_BA_W = Vec3::Zero();  ///< direction, normalised in doubles
};

/// Independent routes to the same depth.
enum class DepthRoute {
  gauss_map,      ///< interval filter over the facets of the Gauss map, then exact arithmetic on those that remain
  minkowski_hull  ///< hull of all vertex differences, then the least facet distance
};

/// Requires a completed scene. Throws InputError for compounds: the depth of a union is a different problem.
PenetrationTruth penetration(const Scene& scene, DepthRoute route = DepthRoute::gauss_map);

/// The exact depth that remains after A is moved by `translation` (doubles, W); 0 if A and B then have no common
/// interior. For judging a claimed separating translation.
Interval depth_after(const Scene& scene, const Vec3& translation);

}  // namespace touchstone::reference
