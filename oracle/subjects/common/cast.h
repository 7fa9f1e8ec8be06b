// Time of impact from an engine that casts shapes: it supports motions of constant velocity only.
#pragma once

#include <functional>
#include <optional>

#include "oracle/subject.h"

namespace touchstone::oracle::subjects {

/// A motion of each body from one pose to another, at constant linear and angular velocity, with a rotation about the
/// shape's origin of less than half a radian. A `Cast` returns the fraction (0 to 1) of the motion after which A and B
/// come into contact, or none.
struct Way {
  Pose from_A, to_A, from_B, to_B;
};
using Cast = std::function<std::optional<double>(const Way&)>;

/// For bodies whose relative motion has constant velocity; declines all others. Casts along successive pieces of the
/// motion until one reports a hit.
Answer<TimeOfImpact> cast_along(const Scene& scene, bool may_turn, const Cast& cast);

}  // namespace touchstone::oracle::subjects
