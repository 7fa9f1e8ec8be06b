// The moves that make a scene smaller, for the minimiser and for RapidCheck's shrinking.
#pragma once

#include <compare>
#include <functional>
#include <optional>
#include <vector>

#include "model/scene.h"

namespace touchstone::oracle::shrink {

/// Returns another scene, perhaps smaller, perhaps not valid; none where the move does not apply. A move may round: the
/// caller decides whether the failure persists. Polytopes whose faces may be wrong are returned without faces.
using Move = std::function<std::optional<Scene>(const Scene&)>;

/// The moves of one kind, from coarse to fine, for scenes about as large as this one.
using Stage = std::function<std::vector<Move>(const Scene&)>;

/// In the order in which they are tried.
const std::vector<Stage>& stages();

std::vector<Move> shrink_to_defaults(const Scene& scene);  ///< default velocities, materials, masses, gravity, names
/// simpler contact numbers; removes what an impact does not need
std::vector<Move> shrink_contacts(const Scene& scene);
std::vector<Move> shrink_motions(const Scene& scene);   ///< fewer times and forces, simpler velocities
std::vector<Move> fewer_pixels(const Scene& scene);     ///< a raster without a half, …, a column or row; no shift
std::vector<Move> fewer_bodies(const Scene& scene);     ///< halves, quarters, …, single bodies
std::vector<Move> fewer_frames(const Scene& sequence);  ///< halves, quarters, …, single frames; two joined to one
std::vector<Move> fewer_placements(const Scene& sequence);
std::vector<Move> shrink_places(const Scene& sequence);  ///< a sequence's poses: none turned, at the origin, on an axis
std::vector<Move> fewer_parts(const Scene& scene);       ///< a part instead of the compound, or one part less
std::vector<Move> shrink_shapes(
    const Scene& scene);  ///< a box's corner, a polytope's bounding box, a box as a polytope
std::vector<Move> many_vertices_less(
    const Scene& scene);  ///< the half, quarter and eighth farthest from the other bodies
std::vector<Move> few_vertices_less(const Scene& scene);  ///< also sixteenths, …, single vertices
std::vector<Move> shrink_poses(const Scene& scene);  ///< the first body at the origin, rotations removed or of few bits
std::vector<Move> facing_along_z(const Scene& scene);  ///< the closest features along z, the gap in a translation
/// all lengths on a grid, rotations perhaps applied to the vertices
std::vector<Move> coarser_grids(const Scene& scene);
std::vector<Move> fewer_bits(const Scene& scene);    ///< each number on its own: 0, then 1, 2, … bits
std::vector<Move> shrink_units(const Scene& scene);  ///< lengths and quaternions of size about 1

/// The order of preference: compares the members from first to last; less is better.
struct Cost {
  std::size_t bodies = 0;
  std::size_t frames = 0;
  long pixels = 0;          ///< of a raster: columns, rows and the shift
  std::size_t samples = 0;  ///< times and forces of a motion
  std::size_t placements = 0;
  std::size_t parts = 0;
  std::size_t vertices = 0;  ///< a box has 8, a sphere 1
  int bits_max = 0;          ///< most significant bits of any number
  std::size_t turned = 0;    ///< bodies and parts with a rotation
  int bits_total = 0;
  int extras = 0;      ///< settings that are not at their defaults
  int magnitudes = 0;  ///< Σ |exponent|: how far the numbers are from 1

  auto operator<=>(const Cost&) const = default;
};
Cost cost(const Scene& scene);

/// The scene after the move, with its faces computed; none if it is not valid or does not cost less.
std::optional<Scene> step(const Scene& scene, const Move& move);

}  // namespace touchstone::oracle::shrink
