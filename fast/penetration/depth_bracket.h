// Proves in doubles an enclosure of the penetration depth of two hulls.
#pragma once

#include "fast/penetration/inner_polytope.h"

namespace touchstone::fast::penetration {

/// lo ≤ depth ≤ hi of two hulls whose interiors meet. With h(n) = max n·(b − a) over the vertices, the depth is the
/// minimum of h over unit vectors n, the distance of 0 from the boundary of M = B − A.
///
/// hi: h(n) for the best n that was tried, and its rounding: translating A by h(n) n separates the two, so any n gives
/// a valid bound. If hi < 0, n separates them by −hi. lo: the least distance of 0 to the triangles of a closed surface
/// with corners in M. If that is positive and the surface encloses 0, a ball of that radius is inside the hull of the
/// corners, which is inside M. The distance of 0 to a triangle is at least n·x at its lowest corner x, for any unit
/// vector n. 0 if doubles prove no overlap.
///
/// Rounding, ε = rounding(A, B) (lin_canny/bracket.h): h(n) is off by at most ε, with n of length 1 within 1.5u. Here
/// it is 1 within 4u, 2.5u L more, L ≥ |w|; 2ε covers both, as ε ≥ 18u (ρ_A + ρ_B). A corner is off by at most 2ε, as
/// in surround.h, and its product with n by 3.1u L + 4u L: 3ε. Both bounds move outward by 4ε.
struct DepthBracket {
  double lo = 0;
  double height = 0;  ///< h(n) as computed
  double hi = 0;
  Vec3 n = Vec3::Zero();  ///< that of hi, unit length within 4u: A moves along it
};

/// Where the search for one pair ended, for its next pose.
struct DepthMemory {
  InnerPolytope polytope;
  Vec3 n = Vec3::Zero();  ///< 0: none
};

/// The expanding-polytope search (van den Bergen 2001): the face nearest to 0 is replaced by a cone from the vertex of
/// M farthest along its normal, until no vertex is farther. It starts with the triangles in `memory` if these still
/// enclose 0, otherwise with four vertices of M. It ends early if n separates the two, and after `most_corners`
/// vertices; then the bounds are valid but wide.
///
/// Requires lengths whose products of three neither over- nor underflow (Hull::fits_doubles).
DepthBracket depth_bracket(const lin_canny::PosedHull& A, const lin_canny::PosedHull& B, DepthMemory& memory);

/// h(n) for a unit vector n, computed.
double height_along(const lin_canny::PosedHull& A, const lin_canny::PosedHull& B, const Vec3& n);

/// A choice: two polytopes of 200 vertices take some 60.
inline constexpr int most_corners = 512;

}  // namespace touchstone::fast::penetration
