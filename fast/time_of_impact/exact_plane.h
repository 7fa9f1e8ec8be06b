// Whether a plane along features separates the cores of two parts, decided exactly.
#pragma once

#include "fast/lin_canny/solid.h"

namespace touchstone::fast::time_of_impact {

/// `X_WA`, `X_WB`: the poses of the bodies. `along`: a face of either beside a vertex, which does not count, or an edge
/// of each. `from_B`: about the normal that is meant, of the two. Planes that touch a core separate it.
bool separates_exactly(const lin_canny::Convex& A, const Pose& X_WA, const lin_canny::Convex& B, const Pose& X_WB,
                       const lin_canny::FeaturePair& along, const Vec3& from_B);

}  // namespace touchstone::fast::time_of_impact
