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
/// Rounding of lo, with ρ ≥ |x| for vertices x, t the shift: turn_error ρ + 3.1uρ each for n·x; the difference of
/// shifts and its product with n, u + 3.1u, and three more operations on terms ≤ |Δt| + ρ_A + ρ_B: 8u|Δt| + (turn_error
/// + 7u)ρ each, with 1.5u for |n|. Rounding of hi: turn_error ρ each for the vertices, 8uρ each for the combination and
/// the sum with t and 3u|Δt|; and 4u of the length itself. So both are less than
///     error = (turn_error + 10u)(ρ_A + ρ_B) + 8u|Δt| + shift errors + 2^-900,   and 4u of the length.
struct Bracket {
  double lo = 0;
  double hi = 0;
  Vec3 a = Vec3::Zero();  ///< witness points, in the pair's frame
  Vec3 b = Vec3::Zero();
};

Bracket bracket(const Placed& A, const Placed& B, const Closest& closest);

/// `error` above: bracket's width is at most twice that when the features are the closest ones, and doubles see it.
double rounding(const Placed& A, const Placed& B);

}  // namespace touchstone::fast::lin_canny
