// A point well inside the intersection of two solids.
#pragma once

#include "fast/lin_canny/posed_hull.h"

namespace touchstone::fast::time_of_impact {

/// Whether p is inside a solid core by more than `error`. A core that is a point has no inside.
bool is_inside(const lin_canny::PosedHull& P, const Vec3& p, double error);

/// Whether doubles prove a point that both have in common. The proof is that it is inside both. Candidates are the
/// middle of the part of an edge of one that lies in the other (the edge is on its own body anyway, within `error`)
/// and, for solids that touch face to face, the mean of all these middles. Each corner of A ∩ B is an end of such a
/// part, so the mean is deep inside relative to the corners, however thin A ∩ B is.
bool share_a_middle(const lin_canny::PosedHull& A, const lin_canny::PosedHull& B, double error);

}  // namespace touchstone::fast::time_of_impact
