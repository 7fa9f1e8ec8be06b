// Exact motions of rasters, and of bodies relative to one.
#pragma once

#include <optional>
#include <vector>

#include "model/scene.h"

namespace touchstone::properties {

/// Moves the given bodies by whole pixels, to the right and up, while the raster stays. None if that rounds, or without
/// a raster.
std::optional<Scene> moved_by_pixels(Scene scene, const std::vector<std::size_t>& bodies, int right, int up);

/// Shifting B's image over A's by some pixels is the same as shifting A's over B's by as many the other way.
Raster with_opposite_shift(Raster raster);

/// Moves the raster by t in its plane. None if that rounds.
std::optional<Raster> translated(Raster raster, const Vec3& t);

/// Multiplies all lengths by 2^k. None if one overflows or loses bits to underflow.
std::optional<Raster> scaled(const Raster& raster, int k);

}  // namespace touchstone::properties
