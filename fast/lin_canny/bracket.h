// Proves in doubles an enclosure of the distance of two hulls.
#pragma once

#include "fast/lin_canny/closest.h"

namespace touchstone::fast::lin_canny {

/// lo ≤ exact distance ≤ hi, lo ≥ 0.
///
/// hi: the distance of two points of the hulls, each a convex combination of vertices. lo: for a direction n, min n·b −
/// max n·a over the vertices: the gap between two parallel planes that separate the hulls. Any n gives a valid bound; a
/// good one comes from the features: perpendicular to those that are edges, a face's own normal, else b − a.
///
/// The highest vertex along n is the feature's own if each of its edges surely leads down: a convex body has no other
/// local maximum. For an edge this holds with each end exempt from the other's test, since the exactly higher end is
/// then the highest of all; for a face it was proved once (hull.h). "Surely" is decided in floats (hull.h,
/// FloatDirection): n rotated into the hull's frame has an error of turn_error, which is nothing beside theirs. If this
/// is not sure, all vertices are tested.
///
/// Rounding, with ρ ≥ |x| for the vertices x (terms with ρ are per hull) and Δt the difference of the shifts:
///   lo   n·x: turn_error ρ, product 3.1uρ; |n| within 1.5u: 1.5uρ; n·Δt: 3.1u + 1.5u, Δt itself u; two more
///        differences of terms ≤ |Δt| + ρ_A + ρ_B: 2u of them. Together (turn_error + 7u)ρ + 8u|Δt|.
///   hi   a point of an edge, R tail + s R along, 0 < s < 1: R's own error 12uρ for the point as a whole; the two
///        products 5.2u(ρ + 2ρ); s times the second and their sum u(2ρ + ρ); + t: u(ρ + |t|). A point of a face,
///        o + α(p − o) + β(q − o): differences, factors and sums 10uρ; R, 17.2uρ; + t. Together
///        (turn_error + 14u)ρ + 2u|Δt|; and 4u of the length.
/// Both also have the errors of the shifts, and 2^-900 for underflow.
struct Bracket {
  double lo = 0;
  double hi = 0;
  Vec3 a = Vec3::Zero();  ///< witness points, in the pair's frame
  Vec3 b = Vec3::Zero();
  Vec3 n = Vec3::Zero();  ///< that of lo; 0 if there is none
  double length = 0;      ///< |b − a|
  double rounding = 0;    ///< rounding(A, B)
};

/// Whether the width is what rounding explains, and so the features the closest ones. The width is twice the rounding
/// error if they are; but a witness in a face is not quite below the vertex, and the direction not quite the best. So
/// half as much again is allowed. A choice: more would give wider enclosures, less would compute exactly more often.
inline bool is_explained_by_rounding(const Bracket& found) { return found.hi - found.lo <= 3 * found.rounding; }

/// The n for lo, from A to B, of length 1 within 1.5u; 0 if the closest points coincide and no feature defines a
/// direction.
Vec3 separating_direction(const PosedHull& A, const PosedHull& B, const Closest& closest);

/// The squared sine of the angle between two edges whose cross product is taken for n. A choice: a smaller limit gives
/// up digits of n by cancellation, a larger one uses the difference of the points where n is better. Any direction
/// gives a valid bound.
constexpr double clearly_crossing = 0x1p-10;

Bracket bracket(const PosedHull& A, const PosedHull& B, const Closest& closest);

/// The error bound of lo, about as large as that of hi: if the features are the closest ones as far as doubles can
/// tell, the width is at most twice that, plus 5 %.
double rounding(const PosedHull& A, const PosedHull& B);

/// lo, given n of length 1 within 1.5u from A to B, and the heights of A along n and of B along −n.
double gap_between(const PosedHull& A, const PosedHull& B, const Vec3& n, double up_to_A, double up_to_B,
                   double rounding_error);

/// What hi adds to the length between two witnesses.
double error_of_hi(const PosedHull& A, const PosedHull& B, double rounding_error);

}  // namespace touchstone::fast::lin_canny
