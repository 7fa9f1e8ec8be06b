// Bodies in the plain numbers that Simbody's wrapping takes.
#pragma once

#include "oracle/subjects/impact_input.h"
#include "oracle/subjects/simbody_stepper.h"

namespace touchstone::oracle::subjects::in_simbody {

/// Fixed: of mass 0, at its origin.
inline RigidBody rigid(const Body& body) {
  RigidBody made;
  const Pose X = centre_of_mass(body);
  made.p_WBcm = X.p_WB;
  made.q_WB = unit_quaternion(X.q_WB);
  if (is_fixed(body)) return made;
  made.v_WBcm = body.velocity.v_WBcm;
  made.w_WB = body.velocity.w_WB;
  if (const auto* given = std::get_if<MassProperties>(&body.mass)) {
    made.mass = given->mass;
    made.moments = given->I_BBcm_B;
    return made;
  }
  made.mass = std::get<Density>(body.mass).value * volume(body.shape);
  if (const auto* sphere = std::get_if<Sphere>(&body.shape)) {
    made.moments = BallOf{sphere->radius};
  } else {
    made.moments = BrickOf{std::get<Box>(body.shape).half_extents};
  }
  return made;
}

}  // namespace touchstone::oracle::subjects::in_simbody
