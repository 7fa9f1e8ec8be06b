// Turning about an axis that stays.
#pragma once

#include "model/frame.h"

namespace touchstone::fast::motion {

/// |w| of any w: 5u.
double length(const Vec3& w);

/// exp([w] tau), of length 1. With φ = |w| tau (known to 7u φ): the half angle's sine and cosine are off by
/// (3 + φ)u each, the axis by 6u; so the turn is off by less than (24 + 10φ)u rad. Where φ > 2⁵⁰ nothing is known of
/// it, and it is 1.
struct SteadyTurn {
  Quaternion q;
  double error = 0;  ///< rad
};

SteadyTurn steady_turn(const Vec3& w, double tau);

}  // namespace touchstone::fast::motion
