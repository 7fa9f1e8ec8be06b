// The steps by which a scene gets smaller: what the minimiser tries, and RapidCheck's shrinker with it.
#pragma once

#include <compare>
#include <functional>
#include <optional>
#include <vector>

#include "model/scene.h"

namespace touchstone::oracle::smaller {

/// Another scene, perhaps smaller, perhaps not even valid; none where the move does not apply. It may round: whether
/// the failure outlives that is for the caller to judge. Polytopes whose faces no longer fit come without.
using Move = std::function<std::optional<Scene>(const Scene&)>;

/// The moves of one kind, from coarse to fine, for scenes about as large as this one.
using Stage = std::function<std::vector<Move>(const Scene&)>;

/// In the order in which they are tried.
const std::vector<Stage>& stages();

std::vector<Move> tidy(const Scene& scene);          ///< velocities, materials, masses, gravity, names: the defaults
std::vector<Move> plainer_contacts(const Scene& scene);  ///< a contact's numbers, and what it makes needless
std::vector<Move> plainer_flights(const Scene& scene);   ///< fewer times and pushes, plainer velocities
std::vector<Move> fewer_pixels(const Scene& scene);      ///< a raster without a half, …, a column or row; no shift
std::vector<Move> fewer_bodies(const Scene& scene);  ///< halves, quarters, …, single bodies
std::vector<Move> fewer_frames(const Scene& film);   ///< halves, quarters, …, single frames; two in one
std::vector<Move> fewer_placements(const Scene& film);
std::vector<Move> plainer_places(const Scene& film);  ///< a film's poses: none turned, at the origin, on an axis
std::vector<Move> fewer_parts(const Scene& scene);   ///< a part for the compound, or a part less
std::vector<Move> plainer_shapes(
    const Scene& scene);  ///< a box's corner, a polytope's bounding box, a box as a polytope
std::vector<Move> many_vertices_less(
    const Scene& scene);  ///< the half, quarter and eighth farthest from the other bodies
std::vector<Move> few_vertices_less(const Scene& scene);  ///< then sixteenths, …, single vertices
std::vector<Move> plainer_poses(const Scene& scene);   ///< the first body at the origin, rotations gone or of few bits
std::vector<Move> facing_along_z(const Scene& scene);  ///< the closest features along z, the gap in a translation
std::vector<Move> coarser_grids(const Scene& scene);  ///< all lengths on a grid, rotations perhaps worked into vertices
std::vector<Move> fewer_bits(const Scene& scene);     ///< each number alone: 0, then 1, 2, … bits
std::vector<Move> plainer_units(const Scene& scene);  ///< lengths and quaternions of size about 1

/// What is preferred: less in the first member that differs.
struct Cost {
  std::size_t bodies = 0;
  std::size_t frames = 0;
  long pixels = 0;  ///< of a raster: columns, rows and the shift
  std::size_t looks = 0;  ///< times and pushes of a flight
  std::size_t placements = 0;
  std::size_t parts = 0;
  std::size_t vertices = 0;  ///< a box has 8, a sphere 1
  int bits_max = 0;          ///< significant bits of the worst number
  std::size_t turned = 0;    ///< bodies and parts with a rotation
  int bits_total = 0;
  int extras = 0;      ///< things that are not at their defaults
  int magnitudes = 0;  ///< Σ |exponent|: how far the numbers are from 1

  auto operator<=>(const Cost&) const = default;
};
Cost cost(const Scene& scene);

/// The move's scene with its faces made, if it is valid and costs less.
std::optional<Scene> step(const Scene& scene, const Move& move);

}  // namespace touchstone::oracle::smaller
