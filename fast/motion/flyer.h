// A body made ready to fly: all that its shape and mass rule, computed once and shared by its flights.
#pragma once

#include "fast/lin_canny/solid.h"
#include "model/scene.h"

namespace touchstone::fast::motion {

/// How a body turns while no torque acts on it.
enum class Turning {
  steady,      ///< ω is constant: the body is fixed, or its inertia is a multiple of 1
  precessing,  ///< two moments are equal: two steady turns, one about L, one about the body's axis
  tumbling     ///< three moments: Euler's equations
};

/// Frames: B the body's own, P its principal axes (P's origin is B's centre of mass).
struct Flyer {
  /// Requires a valid body whose polytopes have their faces. Throws InputError where a shape is no solid.
  explicit Flyer(const Body& body);

  lin_canny::Solid solid;
  Shape shape;
  bool is_fixed = false;
  double mass = 0;                    ///< kg; 0 if fixed
  Vec3 p_BBcm = Vec3::Zero();         ///< m; of a fixed body, its origin
  double centre_error = 0;            ///< m; ≥ |p_BBcm − exact|
  Mat3 I_BBcm_B = Mat3::Zero();       ///< kg m²; 0 if fixed
  double radius = 0;                  ///< m; ≥ |p − p_BBcm| + 2 centre_error for all points p of the body
  Turning turning = Turning::steady;  //
  int axis = 2;                       ///< of P, if precessing: the one whose moment is not like the others
  Vec3 moments = Vec3::Ones();        ///< along P's axes, of any scale
  double moment_error = 0;            ///< relative, of each moment; with P's axes off by at most this (rad)
  Mat3 R_BP = Mat3::Identity();
};

}  // namespace touchstone::fast::motion
