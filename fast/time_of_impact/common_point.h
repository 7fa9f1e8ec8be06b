// A point that two solids have in common.
#pragma once

#include "fast/lin_canny/posed_hull.h"

namespace touchstone::fast::time_of_impact {

/// Whether p is inside a solid core by more than `error`. A core that is a point has no inside.
bool is_inside(const lin_canny::PosedHull& P, const Vec3& p, double error);

/// Whether doubles prove a point that both have in common: an edge of one crosses a face of the other, or a point is
/// inside both. Candidates for that are the middle of the part of an edge of one that lies in the other (the edge is on
/// its own body anyway, within `error`) and, for solids that touch face to face, the mean of all these middles. Each
/// corner of A ∩ B is an end of such a part, so the mean is deep inside relative to the corners, however thin A ∩ B is.
/// At sharp edges a crossing is proved at a depth of some errors, a point inside at that over the sine of their angle.
bool share_a_point(const lin_canny::PosedHull& A, const lin_canny::PosedHull& B, double error);

}  // namespace touchstone::fast::time_of_impact
