// Exact test whether two cores with a common point only touch.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "reference/exact/exact_pose.h"

namespace touchstone::reference {

/// n ≠ 0 with n·a ≥ h ≥ n·b for all vertices a of A and b of B. As few vertices as possible lie on the plane n·x = h.
struct SupportingPlane {
  IntegerVec normal;
  std::vector<int> on_A;
  std::vector<int> on_B;
};

/// The cores share a point x = Σ λ a = Σ λ b, all λ > 0, over `pairs`. Returns none if they share interior points too.
/// Call inside RoundUpward, after enclose().
std::optional<SupportingPlane> supporting_plane(const PosedPair& pair, const std::vector<std::pair<int, int>>& pairs);

/// Normals n ≠ 0 of planes that separate the two: n·a ≥ h ≥ n·b. They include every extreme ray of the cone of such
/// normals.
std::vector<IntegerVec> separating_normals(const PosedPair& pair, const std::vector<std::pair<int, int>>& pairs);

}  // namespace touchstone::reference
