// A convex part of a body at a pose.
#pragma once

#include "fast/contact/feature.h"
#include "fast/lin_canny/posed_hull.h"
#include "fast/lin_canny/solid.h"

namespace touchstone::fast::contact {

/// Refers to the convex part, which must outlive it.
struct Part {
  const lin_canny::Convex* convex = nullptr;
  lin_canny::PosedHull core;  ///< in W
  RigidTransform body;

  bool is_ball() const { return convex->core.vertex_count() == 1; }
};

inline Part part_of(const lin_canny::Convex& convex, const lin_canny::CachedPose& cached_pose,
                    const RigidTransform& body) {
  return {&convex, lin_canny::posed_hull(convex, cached_pose, Vec3::Zero()), body};
}

}  // namespace touchstone::fast::contact
