// Whether a plane along features separates two posed hulls, decided exactly.
#pragma once

#include "fast/exact/difference.h"
#include "fast/lin_canny/posed_hull.h"

namespace touchstone::fast::time_of_impact {

/// A and B: the posed vertices of the two hulls. `along`: a face of either beside a vertex, which does not count, or an
/// edge of each. `from_B`: about the normal that is meant, of the two. Planes that touch a body separate it.
bool separates_exactly(const lin_canny::Hull& hull_A, const exact::PosedPoints& A, const lin_canny::Hull& hull_B,
                       const exact::PosedPoints& B, const lin_canny::FeaturePair& along, const Vec3& from_B);

}  // namespace touchstone::fast::time_of_impact
