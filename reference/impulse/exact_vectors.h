// The vectors of answers, and the same numbers as plain GMP rationals.
#pragma once

#include "reference/exact/rational.h"
#include "reference/impulse.h"
#include "reference/motion/plain_pose.h"

namespace touchstone::reference {

inline ExactVec3 exact_vec(const Triple& v) { return {rational_of(v[0]), rational_of(v[1]), rational_of(v[2])}; }

inline Triple triple(const ExactVec3& v) { return {value_of(v[0]), value_of(v[1]), value_of(v[2])}; }

}  // namespace touchstone::reference
