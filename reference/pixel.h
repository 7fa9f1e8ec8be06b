// Exactly what a raster shows of a scene: two closed pictures laid over each other, and where the bodies behind them
// meet.
//
// A body's picture is its projection along z. Lengths are measured in half pixels from the raster's corner: square (i,
// j) is then [2i, 2i + 2] × [2j, 2j + 2] and its centre (2i + 1, 2j + 1), a square of side 0. One question answers all:
// does a closed square meet the picture of
//   a polytope         the hull of its vertices' projections;
//   a sphere           a disc;
//   A ∩ B, polytopes   the hull of the projections of its extreme points (reference/common_points_impl.h);
//   A ∩ B, else        balls ∩ half-spaces ∩ the prism over the square (reference/balls_impl.h).
// All is rational; a compound is the union of its parts.
#pragma once

#include "model/answers.h"
#include "model/scene.h"
#include "reference/rational.h"

namespace touchstone::reference {

/// Every mask is exact: `conservative` and `meet_conservative` hold the pixels of their definitions and no others. With
/// fewer than two bodies, nothing overlaps and nothing meets.
///
/// Requires a completed scene (reference/validity.h). Throws InputError without a raster. Cost: each pixel against each pair of parts.
Pixels pixel(const Scene& scene);

/// Does the picture of a body meet the pixel's square, or one of the `around` squares on each side of it, on the raster or
/// not?
bool picture_comes_near(const Scene& scene, std::size_t body, int column, int row, int around);

/// Over the pixel and the `around` pixels on each side of it, do A and B come to depths that differ by at most `apart`
/// (m)? Depths of one part of each over a square are an interval, as the part is convex. Requires two bodies.
bool depths_come_near(const Scene& scene, int column, int row, int around, const Rational& apart);

}  // namespace touchstone::reference
