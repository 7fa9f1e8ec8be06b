// The exact position of a point of a posed body.
#pragma once

#include "model/frame.h"
#include "reference/rational.h"

namespace touchstone::reference {

/// p_WA = R(q_WB/|q_WB|) p_BA + p_WB. Rational without a square root, as R = M(q)/|q|² with M quadratic in q
/// (model/frame.h).
RationalVec3 in_world(const Pose& X_WB, const Vec3& p_BA);

}  // namespace touchstone::reference
