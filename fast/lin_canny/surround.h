// A proof of overlap in doubles, for pairs that overlap clearly.
#pragma once

#include <optional>

#include "fast/lin_canny/bracket.h"
#include "fast/lin_canny/simplex.h"

namespace touchstone::fast::lin_canny {

/// A point proved to be inside both hulls, or nothing if doubles do not prove one: the bodies may then be separated,
/// touch, or overlap slightly.
///
/// Gilbert, Johnson & Keerthi's search for four differences b − a whose tetrahedron contains 0. The proof is that
/// tetrahedron: with w the computed differences, each with an error of at most δ (2·rounding(A, B) covers two
/// vertices), and L ≥ |w|, each of its four determinants [w_i w_j w_k] has an error of at most 3δL² + 8uL³, to first
/// order. If all have the same (alternating) sign beyond 4δL² + 16uL³, so have the exact ones, and 0 is strictly inside
/// the hull of four exact points of B − A.
///
/// The search gives up when it makes no progress, or after `most_vertices` vertices. That decides nothing; the exact
/// route does.
std::optional<Vec3> common_point(const PosedHull& A, const PosedHull& B);

/// The same for four differences with their weights, as `reduce` leaves them. `rounding_error`: rounding(A, B).
std::optional<Vec3> common_point(const Simplex& around, double rounding_error);

}  // namespace touchstone::fast::lin_canny
