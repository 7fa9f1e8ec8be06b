// Products of rotations.
#pragma once

#include "model/frame.h"

namespace touchstone::fast::motion {

/// R(product(a, b)) = R(a) R(b). Each component rounds by at most 4u of the sum of the magnitudes of its four terms: as
/// a vector, by less than 8u|a||b|.
Quaternion product(const Quaternion& a, const Quaternion& b);

inline Quaternion conjugate(const Quaternion& q) { return {q.w, -q.x, -q.y, -q.z}; }

/// q/|q| for any q ≠ 0, however small or great: each component has an error of at most 6u.
Quaternion unit(const Quaternion& q);

}  // namespace touchstone::fast::motion
