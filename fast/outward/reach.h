// The greatest distance of a shape's points from a point of its own frame.
#pragma once

#include "model/shape.h"

namespace touchstone::fast::outward {

/// ≥ max ‖p − centre‖ over the shape's points p, by at most 2E: E = 32 u (max ‖p‖₁ + ‖centre‖₁) + 2^-1060, with its
/// offset's ‖·‖₁ added for a compound's part. Both in the unit of fast/outward/outward.h.
double reach(const Shape& shape, const Vec3& centre);

}  // namespace touchstone::fast::outward
