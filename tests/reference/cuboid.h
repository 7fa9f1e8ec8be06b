// A box as the hull of its corners.
#pragma once

#include <vector>

#include "model/scene.h"
#include "reference/convex_hull.h"

namespace touchstone::tests {

inline Polytope cuboid(const Vec3& half_extents) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i) {
    const auto signs = Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    corners.emplace_back(signs.cwiseProduct(half_extents));
  }
  return reference::convex_hull(corners);
}

}  // namespace touchstone::tests
