// Changes of a scene under which the truth changes by a known law, done without rounding. Return none where doubles
// would round.
//
// A raster is changed with the scene; motions that would turn it out of its plane drop it.
//
// Because no bit is lost, the subject is responsible for any change of its answer beyond its own rounding.
#pragma once

#include <optional>

#include "model/scene.h"

namespace touchstone::properties {

/// Reverses the order of the bodies. A contact's normal and a raster's shift are reversed too.
Scene swapped(Scene scene);

/// Reverses the order of the vertices of every polytope, with its faces. None if the scene has no polytope.
std::optional<Scene> relabelled(Scene scene);

/// The same, with the parts of every compound in reverse order too. None if the scene has neither.
std::optional<Scene> relabelled_with_parts(Scene scene);

/// Moves all bodies by the same vector of a lattice as coarse as the scene's. Where that rounds, by the vector that
/// puts the first body at the origin. None if that rounds too, or is 0.
std::optional<Scene> translated(const Scene& scene);

/// The vector by which `translated` moved the scene; 0 for an empty scene.
Vec3 translation_between(const Scene& before, const Scene& after);

/// Turns the world so that x → y → z → x (120° about (1, 1, 1)): q' = (1,1,1,1) q where those sums are exact.
std::optional<Scene> turned(const Scene& scene);
std::optional<Pose> turned(const Pose& X);
Vec3 turned(const Vec3& p);

/// Turns the world by 180° about x, which never rounds: (x, y, z) → (x, −y, −z).
Scene half_turned(Scene scene);

/// Mirrors the world in the plane x = 0. None if the scene has a polytope or compound.
std::optional<Scene> mirrored(Scene scene);

/// Adds the same velocity to that of all bodies. None if that rounds, or if a body is fixed.
std::optional<Scene> boosted(Scene scene);

/// Multiplies all velocities by 2^k. None if one overflows or loses bits to underflow.
std::optional<Scene> sped_up(Scene scene, int k);

/// Multiplies all lengths by 2^k at the same density: given masses by 2^3k, inertias by 2^5k, forces by 2^4k. None if
/// one of them overflows or loses bits to underflow.
std::optional<Scene> scaled(Scene scene, int k);

}  // namespace touchstone::properties
