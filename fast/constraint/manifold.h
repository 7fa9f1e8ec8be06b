// Where two convex bodies touch or may soon: several points, where a face lies over a face.
#pragma once

#include <optional>
#include <vector>

#include "fast/constraint/mover.h"
#include "fast/lin_canny/proximity.h"

namespace touchstone::fast::constraint {

/// Where the gap is: of one that moves over one that is fixed, its own point, which is where it will be pushed; of two
/// that move, the middle, so that what turns one turns the other as much the other way.
struct ContactPoint {
  Vec3 p_WC = Vec3::Zero();
  double gap = 0;  ///< along the normal, m; < 0 where they overlap
};

struct Manifold {
  Vec3 nhat_BA_W = Vec3::Zero();
  std::vector<ContactPoint> points;
};

/// The normal is that of the closest points, or of a face that is so near to it that rounding may explain the rest; of
/// bodies that touch or overlap, the one `before`, or that of the plane that keeps them apart best. Where both bodies
/// have a face within 25° of it, the points are the corners of what the two faces have in common, seen along the
/// normal; else the closest pair alone.
Manifold manifold(const Mover& A, const Mover& B, const lin_canny::Proximity& near, const std::optional<Vec3>& before);

}  // namespace touchstone::fast::constraint
