// Changes of a scene under which the truth changes by a known law, done without rounding; none where doubles cannot.
//
// A raster comes along; the motions that would turn it out of its plane leave it out.
//
// Because no bit is lost, whatever changes in the answer beyond its rounding is the subject's doing.
#pragma once

#include <optional>

#include "model/scene.h"

namespace touchstone::properties {

/// Bodies in the opposite order; a contact's normal points the other way, and so does a raster's shift.
Scene swapped(Scene scene);

/// Vertices of every polytope, and the faces with them, in the opposite order; none if the scene has no polytope.
std::optional<Scene> relabelled(Scene scene);

/// All bodies by the same vector: of a lattice as coarse as the scene; where that rounds, the one that puts the first
/// body at the origin; none if that rounds too, or is no motion.
std::optional<Scene> translated(const Scene& scene);

/// The vector by which `translated` moved (of an empty scene: 0).
Vec3 translation_between(const Scene& before, const Scene& after);

/// The world turned so that x → y → z → x (120° about (1, 1, 1)): q' = (1,1,1,1) q where those sums are exact.
std::optional<Scene> turned(const Scene& scene);
std::optional<Pose> turned(const Pose& X);
Vec3 turned(const Vec3& p);

/// The world turned by half about x, which no double ever rounds: (x, y, z) → (x, −y, −z).
Scene half_turned(Scene scene);

/// The world seen in the plane x = 0; none if a polytope or compound stands in it.
std::optional<Scene> mirrored(Scene scene);

/// The same velocity for all bodies on top of their own; none if that rounds, or if a body is fixed.
std::optional<Scene> boosted(Scene scene);

/// All velocities times 2^k; none if one overflows or loses bits to underflow.
std::optional<Scene> sped_up(Scene scene, int k);

/// All lengths times 2^k, at the same density: given masses times 2^3k, inertias times 2^5k, forces times 2^4k; none if one of them
/// overflows or loses bits to underflow.
std::optional<Scene> scaled(Scene scene, int k);

}  // namespace touchstone::properties
