// Exact motions of rasters, and of bodies over one.
#pragma once

#include <optional>
#include <vector>

#include "model/scene.h"

namespace touchstone::properties {

/// The named bodies by whole pixels, to the right and up, over a raster that stays; none if that rounds, or without a
/// raster.
std::optional<Scene> moved_by_pixels(Scene scene, const std::vector<std::size_t>& bodies, int right, int up);

/// B's picture laid over A's some pixels away is A's laid over B's as many the other way.
Raster with_opposite_shift(Raster raster);

/// By t in its plane; none if that rounds.
std::optional<Raster> translated(Raster raster, const Vec3& t);

/// All lengths times 2^k; none if one overflows or loses bits to underflow.
std::optional<Raster> scaled(const Raster& raster, int k);

}  // namespace touchstone::properties
