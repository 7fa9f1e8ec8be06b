// Do two cores with a common point touch only?
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "reference/exact_pose_impl.h"

namespace touchstone::reference {

/// n ≠ 0 with n·a ≥ h ≥ n·b for all vertices a of A and b of B, and as few of them on the plane n·x = h as can be.
struct SupportingPlane {
  IntegerVec normal;
  std::vector<int> on_A;
  std::vector<int> on_B;
};

/// The cores share a point x = Σ λ a = Σ λ b, all λ > 0, over `pairs`. None if they share inner points, too.
/// Inside RoundUpward, after enclose().
std::optional<SupportingPlane> supporting_plane(const PosedPair& pair, const std::vector<std::pair<int, int>>& pairs);

/// Normals n ≠ 0 of planes that separate the two so, n·a ≥ h ≥ n·b; every extreme ray of their cone is among them.
std::vector<IntegerVec> separating_normals(const PosedPair& pair, const std::vector<std::pair<int, int>>& pairs);

}  // namespace touchstone::reference
