// Contact points of two convex parts that may soon touch, each with its gap, for a solver that closes gaps.
#pragma once

#include <optional>
#include <vector>

#include "fast/contact/part.h"
#include "fast/lin_canny/proximity.h"

namespace touchstone::fast::contact {

struct GapPoint {
  Vec3 p_WC = Vec3::Zero();  ///< in the middle of the gap
  double gap = 0;            ///< m, along the normal; < 0: overlap
};

struct GapManifold {
  Vec3 nhat_BA_W = Vec3::Zero();
  std::vector<GapPoint> points;
};

/// The normal is the direction of the closest points. It is replaced by a face's normal if the two differ by no more
/// than rounding explains. For parts that touch or overlap it is that of the plane of least overlap, or the normal
/// `before` while the overlap along it is at most twice that. If both parts have a face within 25° of the normal, the
/// points are the corners of the two faces' intersection, projected along the normal; otherwise the pair of closest
/// points is the only one.
GapManifold gap_manifold(const Part& A, const Part& B, const lin_canny::Proximity& near,
                         const std::optional<Vec3>& before);

}  // namespace touchstone::fast::contact
