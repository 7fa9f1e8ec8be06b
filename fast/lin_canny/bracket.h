// A proof, in doubles, of how far apart two hulls are.
#pragma once

#include "fast/lin_canny/closest.h"

namespace touchstone::fast::lin_canny {

/// lo ≤ exact distance ≤ hi, lo ≥ 0.
///
/// hi: the length between two points of the hulls, each a convex combination of vertices.
/// lo: for a direction n, min n·b − max n·a over the vertices: the gap between two parallel planes that keep the hulls
/// apart. Any n gives a true bound; a good one comes from the features: at right angles to those that are edges, a
/// face's own normal, else b − a.
///
/// The highest vertex along n is the feature's own if each of its edges surely leads down: a convex body has no other
/// local maximum. For an edge that holds with both ends for one another's exception, since the exactly higher end is
/// then the highest of all; for a face it was proved once (hull.h). "Surely" is n·along < −(turn_error + 6u)|along|: n
/// turned into the hull's frame is off by turn_error, the edge's rounding is u, the product's 3.1u, |n| is 1
/// within 1.5u. Where it is not sure, all vertices are asked.
///
/// Rounding, with ρ ≥ |x| for vertices x and Δt the difference of the shifts, per hull where ρ stands:
///   lo   n·x: turn_error ρ, product 3.1uρ; |n| within 1.5u: 1.5uρ; n·Δt: 3.1u + 1.5u, Δt itself u; two more
///   differences of terms
///        ≤ |Δt| + ρ_A + ρ_B: 2u of them. Together (turn_error + 7u)ρ + 8u|Δt|.
///   hi   a point of an edge, R tail + s R along, 0 < s < 1: R's own error 12uρ for the point as a whole; the two
///   products
///        5.2u(ρ + 2ρ); s times the second and their sum u(2ρ + ρ); + t: u(ρ + |t|). A point of a face, o + α(p − o) +
///        β(q − o): differences, factors and sums 10uρ; R, 17.2uρ; + t. Together (turn_error + 14u)ρ + 2u|Δt|; and 4u
///        of the length.
/// To both come the errors of the shifts, and 2^-900 for what underflows.
struct Bracket {
  double lo = 0;
  double hi = 0;
  Vec3 a = Vec3::Zero();  ///< witness points, in the pair's frame
  Vec3 b = Vec3::Zero();
};

/// The n for lo, from A to B, of length 1 within 1.5u; 0 if the closest points are one and no feature names one.
Vec3 separating_direction(const Placed& A, const Placed& B, const Closest& closest);

Bracket bracket(const Placed& A, const Placed& B, const Closest& closest);

/// The bound for lo, about as large as that for hi: the width is at most twice that, and 5 % more, when the features
/// are the closest ones and doubles see it.
double rounding(const Placed& A, const Placed& B);

}  // namespace touchstone::fast::lin_canny
