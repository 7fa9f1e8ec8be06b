// How a steady turn changes an attitude.
#pragma once

#include "model/frame.h"

namespace touchstone::fast::world {

/// The rotation by `angle` (rad, its axis and length, in W) after that of q; of length 1 within 8u.
///
/// q' = (cos h, sin h · angle/|angle|) q/|q|, h = |angle|/2. + − × ÷ and sqrt alone. Error: (4 + |angle|) u rad, which
/// rounding the angle itself costs too. Beyond 2⁵⁰ rad, where doubles do not tell it any more, q as it was.
Quaternion turned(const Quaternion& q, const Vec3& angle);

}  // namespace touchstone::fast::world
