// Converts bodies to the plain numbers that the wrapper of Simbody takes.
#pragma once

#include "oracle/subjects/common/impact_input.h"
#include "oracle/subjects/simbody/stepper.h"

namespace touchstone::oracle::subjects::in_simbody {

/// A fixed body has mass 0 and its frame at its origin.
inline RigidBody rigid(const Body& body) {
  RigidBody made;
  const Pose X = centre_of_mass(body);
  made.p_WBcm = X.p_WB;
  made.q_WB = rotation(X.q_WB);
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
