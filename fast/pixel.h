// Collision at pixel resolution: masks laid over each other, and depth intervals above each pixel.
#pragma once

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::fast {

/// Laws: `sampled`, `overlap` and `meet_sampled` are exact; `conservative` and `meet_conservative` hold the exact ones,
/// and with E = 256 · 2^-53 · (greatest ‖p‖₁ of a body's points, its pose's offsets and the raster's coordinates)
///   each marked square of `conservative` is within E of the picture, along each axis;
///   above each marked square of `meet_conservative`, and E around it, points of A and B come to depths 2E apart or
///   less.
/// A convex part has one interval of depths a pixel; a compound has one for each of its parts.
///
/// Requires a valid scene with a raster, whose polytopes have their faces. Throws InputError without a raster and
/// std::range_error if lengths are beyond 2^1000 m.
/// Cost: O(faces · pixels they cover) cuts, and exact arithmetic for centres within E of an edge's projection.
Pixels pixel(const Scene& scene);

}  // namespace touchstone::fast
