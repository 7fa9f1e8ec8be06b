// Mutations that bring into a scene what neither it nor the other one has. Without them a pool that begins with one box
// never has a ball, a compound, a given mass or a force.
#pragma once

#include <optional>

#include "model/scene.h"
#include "properties/random.h"

namespace touchstone::properties::fuzzing {

/// None if the scene has nothing that the mutation applies to. The result may lack faces, and may be invalid.
using Changed = std::optional<Scene>;

/// A solid becomes a ball, a box, or a polytope of 4 to 48 vertices, about as large.
Changed other_solid(Scene scene, const Scene& other, Random& random);

/// A body gets one part more, a solid of this scene or of the other one: face to face with its own, or shifted from
/// there.
Changed join_part(Scene scene, const Scene& other, Random& random);

/// A compound loses a part; one of two leaves the other one alone.
Changed drop_part(Scene scene, const Scene& other, Random& random);

/// A uniform density, mass properties that are given, or fixed.
Changed other_mass(Scene scene, const Scene& other, Random& random);

/// The contact's normal becomes one of small integers, over its length.
Changed other_normal(Scene scene, const Scene& other, Random& random);

/// Rows, columns, the size of pixels, or the shift.
Changed other_raster(Scene scene, const Scene& other, Random& random);

/// One sample more, twice or half the time, another start of a body, another envelope or none.
Changed other_times(Scene scene, const Scene& other, Random& random);

/// A force begins to act on a body, or one less does.
Changed other_forces(Scene scene, const Scene& other, Random& random);

/// In a new frame, or in the last one, a body is moved, removed or put back.
Changed place(Scene scene, const Scene& other, Random& random);

}  // namespace touchstone::properties::fuzzing
