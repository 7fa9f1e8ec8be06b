// The exact distance between bodies 0 (A) and 1 (B) of a scene, its closest features, and a proof.
//
// A convex body is a core (a point or a polytope) swollen by a radius (a sphere's; else 0). Let D = coreA − coreB (the
// Minkowski difference, a polytope), d* the point of D nearest to 0 (unique, as D is convex), and r = rA + rB. Then
//   separated    |d*| > r     distance = |d*| − r
//   touching     |d*| = r, and no common interior
//   overlapping  otherwise.
// d* and |d*|² are rational. F_A = {a in coreA's vertices : d*·a least} and F_B = {b : d*·b greatest} are the vertex
// sets of faces; the closest pairs of the cores are exactly {(x, y) in hull F_A × hull F_B : x − y = d*}. If d* = 0,
// the feature sets are the least faces that hold every common point (touching: the vertices on the certificate's
// supporting plane, which is chosen so that they are least), or empty (overlapping).
// For compounds: the least distance over all pairs of parts. Among equal ones the first pair counts, in the order of
// the parts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/answers.h"
#include "model/scene.h"
#include "reference/certificate.h"
#include "reference/rational.h"

namespace touchstone::reference {

/// The distance of bodies 0 (A) and 1 (B), in W.
struct DistanceTruth {
  Verdict verdict = Verdict::separated;
  int part_A = 0;  ///< the pair of parts that the fields below describe
  int part_B = 0;
  Rational core_squared;    ///< |d*|², m²
  Rational radius_sum;      ///< r, m
  RationalVec3 difference;  ///< d* = a* − b*
  Feature feature_A;        ///< F_A, with all ties
  Feature feature_B;
  /// Closest points of the swollen bodies, to the nearest doubles; one pair, where several tie
  Vec3 p_WCa = Vec3::Zero();
  Vec3 p_WCb = Vec3::Zero();
  Interval distance;        ///< tightest doubles around max(0, |d*| − r); [0, 0] unless separated
  Certificate certificate;  ///< only by route `certified`; the other routes leave it empty (no pairs)
};

/// Independent routes to the same truth. They share only the exact pose.
enum class Route {
  certified,    ///< a floating-point guess, then proved or improved exactly: the default
  brute_force,  ///< every vertex, edge and face pair in exact arithmetic: the definition itself
  qp            ///< CGAL's exact quadratic programming
};

/// Requires a completed scene (reference/validity.h) of at least two bodies.
DistanceTruth distance(const Scene& scene, Route route = Route::certified);

/// The tightest doubles around the distance (m) of a point (exact, in W) from a body; [0, 0] on the body and inside it.
/// For judging witness points. Requires a body of a completed scene.
Interval distance_to_body(const Body& body, const Vec3& p_W);

}  // namespace touchstone::reference
