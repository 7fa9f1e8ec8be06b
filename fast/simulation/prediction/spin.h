// The orientation of a ball after a rotation.
#pragma once

#include "model/frame.h"

namespace touchstone::fast::simulation {

/// The rotation of q followed by that by the vector `angle` (rad; along the axis, in W). Its norm is 1 within 8u.
///
/// q' = (cos h, sin h · angle/|angle|) q/|q|, h = |angle|/2, computed by + − × ÷ and sqrt alone. Error: (4 + |angle|) u
/// rad, as much as rounding the angle itself causes. Beyond 2⁵⁰ rad doubles cannot resolve the angle, and q is
/// returned, normalized by a power of two only.
Quaternion turned(const Quaternion& q, const Vec3& angle);

}  // namespace touchstone::fast::simulation
