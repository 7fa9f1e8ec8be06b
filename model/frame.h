// Points, poses and boxes. Their components are IEEE doubles, and each double is taken as the exact rational that it
// is.
//
// Monogram notation: p_WA is the position of point A in frame W, X_WB the pose of frame B in W, R_WB its rotation;
// adjacent letters cancel (p_WA = X_WB p_BA). W is the world, B a body's own frame. Units: SI (m, kg, s, rad).
#pragma once

#include <Eigen/Core>

namespace touchstone {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// The rotation of q/|q|, exactly, for any non-zero q. q and s·q (s ≠ 0) are the same rotation, so q is never
/// normalised.
///
///   R(q) = 1/|q|² · [ w²+x²−y²−z²   2(xy−wz)      2(xz+wy)    ]
///                   [ 2(xy+wz)      w²−x²+y²−z²   2(yz−wx)    ]
///                   [ 2(xz−wy)      2(yz+wx)      w²−x²−y²+z² ]
struct Quaternion {
  double w = 1;
  double x = 0;
  double y = 0;
  double z = 0;

  bool operator==(const Quaternion&) const = default;
};

/// X_WB: p_WA = R(q_WB) p_BA + p_WB.
struct Pose {
  Vec3 p_WB = Vec3::Zero();
  Quaternion q_WB;

  bool operator==(const Pose& other) const { return p_WB == other.p_WB && q_WB == other.q_WB; }
};

/// A closed interval [lo, hi] that contains a real number.
struct Interval {
  double lo = 0;
  double hi = 0;

  /// For an interval of two neighbouring doubles this is one of them.
  double middle() const { return lo + (hi - lo) / 2; }

  bool operator==(const Interval&) const = default;
};

/// A closed axis-aligned box in W. Boxes that share only a boundary point overlap.
struct Aabb {
  Vec3 lo = Vec3::Zero();
  Vec3 hi = Vec3::Zero();

  bool operator==(const Aabb& other) const { return lo == other.lo && hi == other.hi; }
};

}  // namespace touchstone
