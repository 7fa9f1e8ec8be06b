// Access to a scene's convex solids and numbers, for code that changes them.
#pragma once

#include <vector>

#include "model/scene.h"

namespace touchstone::oracle {

/// One convex solid: a part of a compound, else the body itself (part 0).
struct Slot {
  std::size_t body = 0;
  int part = 0;
};

std::vector<Slot> slots(const Scene& scene);
ConvexShape shape_at(const Scene& scene, Slot slot);
void set_shape(Scene& scene, Slot slot, const ConvexShape& shape);

/// Vertices of a box or polytope in its own frame, in the order of model/shape.h; empty for a sphere.
std::vector<Vec3> corners(const ConvexShape& shape);

/// Every length of the scene: shapes, translations, a contact's point. After a vertex is changed the faces may be
/// wrong.
std::vector<double*> lengths(Scene& scene);

/// Every component of every quaternion.
std::vector<double*> quaternion_components(Scene& scene);

/// Every number of given masses and densities.
std::vector<double*> mass_numbers(Scene& scene);

/// For a scene with a contact or a motion: every velocity, the finite coefficients, given moments of inertia, and the
/// motion's gravity, times and forces.
std::vector<double*> motion_numbers(Scene& scene);

/// Removes the faces of polytopes, to be computed again.
void drop_faces(Scene& scene);

/// Gives polytopes without faces their hull, without the vertices inside it. Then checks all the rules of a valid
/// scene. Throws InputError.
Scene with_faces(Scene scene);

/// R(q), rounded.
Mat3 rounded_rotation(const Quaternion& q);

/// The number of bits from the first to the last that is set: 0 for 0, 1 for a power of two, 3 for 5, at most 53.
int significant_bits(double x);

}  // namespace touchstone::oracle
