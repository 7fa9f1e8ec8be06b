// A point in the midst of what two solids have in common.
#pragma once

#include "fast/lin_canny/placed.h"

namespace touchstone::fast::meeting {

/// Whether p is inside a solid core by more than `error`. A point has no inside.
bool is_inside(const lin_canny::Placed& P, const Vec3& p, double error);

/// Whether doubles show a point that both have. The proof is that it is inside; the guesses are the middle of what an
/// edge of one leaves in the other (of its own body it is a point anyway, within `error`), and, where solids meet flat,
/// the mean of all these: each corner of A ∩ B is an end of one of them, so it is as far inside as corners go, however
/// thin the slice.
bool share_a_middle(const lin_canny::Placed& A, const lin_canny::Placed& B, double error);

}  // namespace touchstone::fast::meeting
