// The ball about its centre of mass that holds a body however it turns.
#pragma once

#include <optional>

#include "fast/bounds/outward.h"
#include "model/scene.h"

namespace touchstone::fast::outward {

/// Of a body that is not fixed. A free body turns about its centre of mass c*; with c computed and |c − c*| ≤ δ, a
/// point p comes no further from X_WB c than |p − c*| + |c − c*| ≤ max ‖p − c‖ + 2δ.
struct SpunBall {
  Vec3 centre = Vec3::Zero();  ///< c in B, multiples of `unit`
  double radius = 0;           ///< likewise
  double least_mass = 0;       ///< kg
  bool is_itself = false;      ///< the body is this very ball: turning changes nothing
};

/// None for a fixed body. Throws InputError as centre_of_mass does.
std::optional<SpunBall> spun_ball(const Body& body);

/// The ball where the body stands.
void grow(Grower& grower, const SpunBall& ball, const Pose& X_WB);

}  // namespace touchstone::fast::outward
