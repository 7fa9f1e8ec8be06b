// How an engine that casts shapes is asked when two bodies first meet: its motions have constant velocities.
#pragma once

#include <functional>
#include <optional>

#include "oracle/subject.h"

namespace touchstone::oracle::subjects {

/// From one pose of each body to another, straight and evenly, turning about the shapes' origins by less than half a
/// radian: the part of the way (0 to 1) after which A and B meet; none: they do not.
struct Way {
  Pose from_A, to_A, from_B, to_B;
};
using Cast = std::function<std::optional<double>(const Way&)>;

/// Of bodies whose relative motion is such; others are declined. Way after way, until a cast tells a hit.
Answer<TimeOfImpact> cast_along(const Scene& scene, bool may_turn, const Cast& cast);

}  // namespace touchstone::oracle::subjects
