// The exact distance between bodies 0 (A) and 1 (B) of a scene, its closest features, and a proof.
//
// A convex body is a core (a point, or a polytope) swollen by a radius (a sphere's; else 0). With D = coreA − coreB (the
// Minkowski difference, a polytope) let d* be the point of D nearest to 0 (unique, as D is convex); r = rA + rB. Then
//   separated    |d*| > r     distance = |d*| − r
//   touching     |d*| = r, and no common interior
//   overlapping  otherwise.
// d* and |d*|² are rational. F_A = {a in coreA's vertices : d*·a least}, F_B = {b : d*·b greatest} are the vertex sets of
// faces; the closest pairs of the cores are exactly {(x, y) in hull F_A × hull F_B : x − y = d*}. With d* = 0 the feature
// sets are the least faces that hold every common point (touching: the vertices on the certificate's supporting plane, which
// is chosen so that they are least) or empty (overlapping).
// Between compounds, the least over the pairs of parts; ties in the parts' order.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/answers.h"
#include "model/scene.h"
#include "reference/certificate.h"
#include "reference/rational.h"

namespace touchstone::reference {

struct DistanceTruth {
  Verdict verdict = Verdict::separated;
  int part_A = 0;  ///< the parts that the fields below speak of
  int part_B = 0;
  Rational core_squared;  ///< |d*|², m²
  Rational radius_sum;    ///< r, m
  RationalVec3 difference;  ///< d* = a* − b*
  Feature feature_A;        ///< F_A, all ties
  Feature feature_B;
  Vec3 p_WCa = Vec3::Zero();  ///< closest points of the swollen bodies (one pair, where several tie), to the nearest doubles
  Vec3 p_WCb = Vec3::Zero();
  Interval distance;  ///< tightest doubles around max(0, |d*| − r); [0, 0] unless separated
  Certificate certificate;  ///< of route `certified`; the others are second opinions and leave it empty (no pairs)
};

/// Independent routes to the same truth; they share the exact pose and nothing else.
enum class Route {
  certified,    ///< a floating-point guess, proved or improved exactly: the route for daily use
  brute_force,  ///< every vertex, edge and face pair in exact arithmetic: the definition
  qp            ///< CGAL's exact quadratic programming
};

/// Requires a completed scene (reference/validity.h) of at least two bodies.
DistanceTruth distance(const Scene& scene, Route route = Route::certified);

/// The exact squared distance of a point (doubles, in W) to the core of the body nearest to it; 0 inside. For judging witnesses.
/// For a swollen part the enclosure of (distance to core − radius), 0 inside.
Interval distance_to_body(const Body& body, const Vec3& p_W);

}  // namespace touchstone::reference
