// Rotation about a constant axis.
#pragma once

#include "model/frame.h"

namespace touchstone::fast::motion {

/// |w| for any w, with an error of 5u.
double length(const Vec3& w);

/// exp([w] tau), of length 1. With φ = |w| tau (known to 7u φ): the half angle's sine and cosine have errors of (3 +
/// φ)u each, the axis of 6u; so the rotation has an error of less than (24 + 10φ)u rad. For φ > 2⁵⁰ nothing is known
/// about the rotation, and the result is 1.
struct SteadyTurn {
  Quaternion q;
  double error = 0;  ///< rad
};

SteadyTurn steady_turn(const Vec3& w, double tau);

}  // namespace touchstone::fast::motion
