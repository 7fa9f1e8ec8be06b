// Exact raster of a scene: which pixels the projections of A and B cover, and where A and B overlap behind them.
//
// A body is projected along z. Lengths are measured in half pixels from the raster's corner: pixel (i, j) is the square
// [2i, 2i + 2] × [2j, 2j + 2], and its centre (2i + 1, 2j + 1) is a square of side 0. All masks reduce to one question:
// does a closed square intersect the projection of
//   a polytope         the hull of its projected vertices;
//   a sphere           a disc;
//   A ∩ B, polytopes   the hull of its projected extreme points (reference/distance/common_points.h);
//   A ∩ B, else        balls ∩ half-spaces ∩ the prism over the square (reference/distance/balls.h).
// All arithmetic is rational. A compound is the union of its parts.
#pragma once

#include "model/answers.h"
#include "model/scene.h"
#include "reference/rational.h"

namespace touchstone::reference {

/// Every mask is exact: `conservative` and `meet_conservative` hold the pixels of their definitions and no others. With
/// fewer than two bodies the overlap masks are empty.
///
/// Requires a completed scene (reference/validity.h). Throws InputError without a raster. Cost: each pixel against each
/// pair of parts.
Pixels pixel(const Scene& scene);

/// Does the projection of a body intersect the pixel's square, or one of the `around` squares on each side of it? The
/// squares may be off the raster.
bool projection_comes_near(const Scene& scene, std::size_t body, int column, int row, int around);

/// Do A and B reach depths that differ by at most `apart` (m), over the pixel and the `around` pixels on each side of
/// it? The depths of one part over a square are an interval, as the part is convex. Requires two bodies.
bool depths_come_near(const Scene& scene, int column, int row, int around, const Rational& apart);

}  // namespace touchstone::reference
