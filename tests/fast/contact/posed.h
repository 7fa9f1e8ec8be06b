// Convex parts at poses, for tests of contact geometry.
#pragma once

#include <cmath>

#include "fast/contact/part.h"
#include "fast/lin_canny/proximity.h"

namespace touchstone::fast::contact {

/// A convex body with its centre of mass at its origin.
class Posed {
 public:
  Posed(const Shape& shape, const Vec3& p_WB, const Quaternion& q_WB = {})
      : solid_(shape), at_(Pose{p_WB, q_WB}), part_(part_of(solid_.parts().front(), at_, {p_WB, at_.R_WB})) {}
  Posed(const Posed&) = delete;
  Posed& operator=(const Posed&) = delete;

  const lin_canny::Solid& solid() const { return solid_; }
  const lin_canny::CachedPose& at() const { return at_; }
  const Part& part() const { return part_; }

 private:
  lin_canny::Solid solid_;
  lin_canny::CachedPose at_;
  Part part_;  ///< refers to solid_
};

inline lin_canny::Proximity proximity_of(const Posed& A, const Posed& B) {
  lin_canny::FeaturePair memory;
  return lin_canny::proximity(A.solid().parts().front(), A.at(), B.solid().parts().front(), B.at(), memory);
}

inline Box cube() { return {Vec3::Ones()}; }    // its sides are 2
inline Box plate() { return {Vec3(4, 4, 1)}; }  // its upper face is at z = 1

/// A turn by 45°, so that an edge of a cube is lowest, at √2 below its centre.
inline Quaternion eighth_turn(const Vec3& axis) {
  const double tan = std::sqrt(2.0) - 1;  // of half the angle
  return {1, tan * axis.x(), tan * axis.y(), tan * axis.z()};
}

}  // namespace touchstone::fast::contact
