// A body made ready to fly: all that its shape and mass rule, computed once and shared by its flights.
#pragma once

#include "fast/lin_canny/solid.h"
#include "fast/motion/inertia.h"
#include "model/scene.h"

namespace touchstone::fast::motion {

/// How a body turns while no torque acts on it.
enum class Turning {
  steady,      ///< ω is constant: the body is fixed, or its inertia is a multiple of 1
  precessing,  ///< two moments are equal: two steady turns, one about L, one about the body's axis
  tumbling     ///< three moments: Euler's equations
};

struct Flyer {
  /// Requires a valid body whose polytopes have their faces. Throws InputError where a shape is no solid.
  explicit Flyer(const Body& body);

  lin_canny::Solid solid;
  Shape shape;
  bool is_fixed = false;
  double mass = 0;               ///< kg; 0 if fixed
  Vec3 p_BBcm = Vec3::Zero();    ///< m; of a fixed body, its origin
  double centre_error = 0;       ///< m; ≥ |p_BBcm − exact|
  Mat3 I_BBcm_B = Mat3::Zero();  ///< kg m²; 0 if fixed
  double radius = 0;             ///< m; ≥ |p − exact centre of mass| + centre_error for all points p of the body
  Inertia inertia;               ///< of a fixed body, none
  Turning turning = Turning::steady;
  int axis = 2;  ///< if precessing: the axis whose moment is not like the others
};

}  // namespace touchstone::fast::motion
