// The contact patch of two bodies: the corners of the common part of two touching faces, or of a face and an edge.
#pragma once

#include <vector>

#include "fast/lin_canny/solid.h"

namespace touchstone::fast::contact {

/// The corners, in order around it, of the convex region in which A and B are within `within` (m) of each other's
/// outermost planes across n̂; `p_WC` alone if the region is a point. Velocities are affine over the region, so its
/// point of fastest approach is a corner.
///
/// For each pair of parts whose outermost vertices along n̂ are that close, their outlines in the plane across n̂ are
/// clipped by each other.
std::vector<Vec3> patch(const lin_canny::Solid& A, const lin_canny::CachedPose& at_A, const lin_canny::Solid& B,
                        const lin_canny::CachedPose& at_B, const Vec3& nhat_BA_W, const Vec3& p_WC, double within);

/// Whether the projection of p along n̂ is in the interior of the corners' region.
bool supports(const std::vector<Vec3>& corners, const Vec3& nhat_W, const Vec3& p_W);

}  // namespace touchstone::fast::contact
