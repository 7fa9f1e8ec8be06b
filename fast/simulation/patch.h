// Where two bodies touch that touch at more than a point: the corners of the common part of two faces or edges.
#pragma once

#include <vector>

#include "fast/simulation/body.h"

namespace touchstone::fast::world {

/// Corners of the convex region in which A and B are within `within` of each other's outermost planes across n̂, at time
/// t, one after the other around it; `p_WC` alone if that is a point. Where bodies touch in a region, velocities are
/// affine over it, so the corner that approaches fastest is the point that does.
///
/// Of each pair of parts whose outermost vertices along n̂ are that near: their outlines in the plane across n̂, clipped
/// by each other (Sutherland & Hodgman 1974).
std::vector<Vec3> patch(const Mover& a, const Mover& b, double t, const Vec3& nhat_BA_W, const Vec3& p_WC,
                        double within);

/// Whether the foot of p along n̂ is inside the corners' region, in which it must not be on the rim.
bool carries(const std::vector<Vec3>& corners, const Vec3& nhat_W, const Vec3& p_W);

}  // namespace touchstone::fast::world
