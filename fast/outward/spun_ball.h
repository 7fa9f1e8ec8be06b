// The ball about its centre of mass that contains a body at any orientation.
#pragma once

#include <optional>

#include "fast/outward/outward.h"
#include "model/scene.h"

namespace touchstone::fast::outward {

/// For a body that is not fixed. A free body rotates about its centre of mass c*. With c computed and |c − c*| ≤ δ, the
/// distance of a point p from X_WB c is at most |p − c*| + |c − c*| ≤ max ‖p − c‖ + 2δ.
struct SpunBall {
  Vec3 centre = Vec3::Zero();  ///< c in B, multiples of `unit`
  double radius = 0;           ///< likewise
  double least_mass = 0;       ///< kg
  bool is_itself = false;      ///< the body is this very ball: rotation changes nothing
};

/// Nothing for a fixed body. Throws InputError as centre_of_mass does.
std::optional<SpunBall> spun_ball(const Body& body);

/// Adds the ball at the body's pose.
void grow(Grower& grower, const SpunBall& ball, const Pose& X_WB);

}  // namespace touchstone::fast::outward
