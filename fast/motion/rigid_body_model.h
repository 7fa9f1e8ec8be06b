// A rigid body prepared for motion: everything that follows from shape and mass, computed once and shared by its
// motions.
#pragma once

#include "fast/lin_canny/solid.h"
#include "fast/motion/inertia.h"
#include "model/scene.h"

namespace touchstone::fast::motion {

/// How a body rotates without torque.
enum class Turning {
  steady,      ///< ω is constant: the body is fixed, or its inertia is a multiple of the identity
  precessing,  ///< two equal moments: two steady rotations, one about L, one about the body's axis
  tumbling     ///< three different moments: Euler's equations
};

struct RigidBodyModel {
  /// Requires a valid body whose polytopes have their faces. Throws InputError if a shape is not a solid.
  explicit RigidBodyModel(const Body& body);

  lin_canny::Solid solid;
  Shape shape;
  bool is_fixed = false;
  double mass = 0;               ///< kg; 0 if fixed
  Vec3 p_BBcm = Vec3::Zero();    ///< m; for a fixed body, its origin
  double centre_error = 0;       ///< m; ≥ |p_BBcm − exact|
  Mat3 I_BBcm_B = Mat3::Zero();  ///< kg m²; 0 if fixed
  double radius = 0;             ///< m; ≥ |p − exact centre of mass| + centre_error for all points p of the body
  Inertia inertia;               ///< unused for a fixed body
  Turning turning = Turning::steady;
  int axis = 2;  ///< if precessing: the axis whose moment differs from the others
};

}  // namespace touchstone::fast::motion
