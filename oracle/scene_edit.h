// A scene as its convex solids and its numbers, for those who change it.
#pragma once

#include <vector>

#include "model/scene.h"

namespace touchstone::oracle {

/// One convex solid: of a compound a part, else the body itself (part 0).
struct Slot {
  std::size_t body = 0;
  int part = 0;
};

std::vector<Slot> slots(const Scene& scene);
ConvexShape shape_at(const Scene& scene, Slot slot);
void set_shape(Scene& scene, Slot slot, const ConvexShape& shape);

/// Vertices of a box or polytope in its own frame, in the order of model/shape.h; of a sphere none.
std::vector<Vec3> corners(const ConvexShape& shape);

/// Every length of the scene: shapes, translations, a contact's point. Writing to a vertex leaves faces that may no longer fit.
std::vector<double*> lengths(Scene& scene);

/// Every component of every quaternion.
std::vector<double*> quaternion_components(Scene& scene);

/// Every number of stated masses and densities.
std::vector<double*> mass_numbers(Scene& scene);

/// Of a scene with a contact or a flight, every velocity, the coefficients that are finite, stated moments of inertia, and
/// a flight's gravity, times and forces.
std::vector<double*> motion_numbers(Scene& scene);

/// Polytopes lose their faces: they will be made anew.
void drop_faces(Scene& scene);

/// R(q), rounded.
Mat3 rounded_rotation(const Quaternion& q);

/// How many bits from the first to the last that is set: 0 for 0, 1 for a power of two, 3 for 5, at most 53.
int significant_bits(double x);

}  // namespace touchstone::oracle
