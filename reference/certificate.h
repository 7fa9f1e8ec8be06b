// A proof of a verdict, and a short independent checker: distance/certificate_check.cpp shares no code with
// distance.cpp.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "model/answers.h"
#include "model/scene.h"
#include "reference/rational.h"

namespace touchstone::reference {

/// A proof for the cores of one pair of convex parts:
///   apart        `direction` n and `pairs` with n = Σ weights·(a − b) over the pairs, and n·(a − b) ≥ n·n for all
///                vertices a of A and b of B. So n is the point of A − B nearest to 0, and |n| the cores' distance.
///   touching     direction n ≠ 0 with n·(a − b) ≥ 0 for all a, b (no common interior), and weights ≥ 0, Σ = 1, with
///                Σ weights·(a − b) = 0 (a common point).
///   overlapping  weights > 0, Σ = 1, with Σ weights·(a − b) = 0, over pairs whose differences span space. So 0 is
///                inside A − B, and there is a common interior point. Usually 4 pairs, a tetrahedron around 0; at most
///                8, as 4 are not always enough (0 in the middle of an octahedron).
struct Certificate {
  Verdict cores = Verdict::separated;
  int part_A = 0;
  int part_B = 0;
  RationalVec3 direction;
  std::vector<std::pair<int, int>> pairs;  ///< (vertex of A's part, vertex of B's part)
  std::vector<Rational> weights;           ///< one for each pair
};

/// m: of a certificate of overlap, the radius of the ball around 0 in the hull of its differences a − b, rounded down.
/// The hull is in A − B, so no translation shorter than that separates the two. It is the least distance of 0 from a
/// plane through three differences with none beyond it, in rationals: long doubles far from the origin lose the side on
/// which 0 is.
double inner_radius(const Certificate& certificate, const Scene& scene);

/// Returns "" if the certificate proves its verdict about bodies 0 and 1; else says what is wrong with it.
std::string check(const Certificate& certificate, const Scene& scene);

}  // namespace touchstone::reference
