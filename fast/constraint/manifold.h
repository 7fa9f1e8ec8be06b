// The contact points of two convex bodies that touch or may soon touch. There are several where faces oppose each
// other.
#pragma once

#include <optional>
#include <vector>

#include "fast/constraint/stepper_body.h"
#include "fast/lin_canny/proximity.h"

namespace touchstone::fast::constraint {

/// The contact point lies in the gap. If one body is fixed, it is the point of the moving body, where the impulse will
/// act. If both move, it is the middle of the gap, so that equal impulses have opposite moments.
struct ContactPoint {
  Vec3 p_WC = Vec3::Zero();
  double gap = 0;  ///< m, along the normal; < 0: overlap
};

struct Manifold {
  Vec3 nhat_BA_W = Vec3::Zero();
  std::vector<ContactPoint> points;
};

/// The normal is the direction of the closest points. It is replaced by a face's normal if the two differ by no more
/// than rounding explains. For bodies that touch or overlap it is the normal `before`, or else that of the plane of
/// greatest separation. If both bodies have a face within 25° of the normal, the points are the corners of the two
/// faces' intersection, projected along the normal; otherwise the pair of closest points is the only one.
Manifold manifold(const StepperBody& A, const StepperBody& B, const lin_canny::Proximity& near,
                  const std::optional<Vec3>& before);

}  // namespace touchstone::fast::constraint
