// Collision at pixel resolution: overlap of masks, and of depth intervals above each pixel.
#pragma once

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::fast {

/// Laws: `sampled`, `overlap` and `meet_sampled` are exact; `conservative` and `meet_conservative` contain the exact
/// sets, and with E = 256 · 2^-53 · (greatest ‖p‖₁ of a body's points, its pose's offsets and the raster's coordinates)
///   each marked square of `conservative` is within E of the exact projection, along each axis;
///   above each marked square of `meet_conservative`, and E around it, there are points of A and B whose depths differ
///   by at most 2E.
/// A convex part has one interval of depths per pixel; a compound has one for each of its parts.
///
/// Requires a valid scene with a raster, whose polytopes have their faces. Throws InputError without a raster, and
/// std::range_error if lengths exceed 2^1000 m. Cost: O(faces · pixels they cover) cuts, and exact arithmetic for
/// centres within E of an edge's projection.
Pixels pixels(const Scene& scene);

}  // namespace touchstone::fast
