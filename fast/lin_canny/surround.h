// A proof of overlap in doubles, for pairs that are clearly in each other.
#pragma once

#include <optional>

#include "fast/lin_canny/bracket.h"

namespace touchstone::fast::lin_canny {

/// A point that both hulls surely have in their insides, or none if doubles do not show one: the bodies may then be
/// apart, touch, or overlap by a little.
///
/// Gilbert, Johnson & Keerthi's search for four differences b − a whose tetrahedron has 0 inside. The proof is that
/// tetrahedron: with w the computed differences, each off by at most δ (2·rounding(A, B) covers two vertices), L ≥ |w|,
/// each of its four determinants [w_i w_j w_k] is off by at most 3δL² + 8uL³, to first order. Where all have one
/// (alternating) sign beyond 4δL² + 16uL³, the exact ones have it too, and 0 is strictly inside the hull of four exact
/// points of B − A.
///
/// The search gives up when it does not get on, or after `patience` vertices: that is no answer, and the exact route
/// has one.
std::optional<Vec3> common_point(const Placed& A, const Placed& B);

}  // namespace touchstone::fast::lin_canny
