// Rotations in plain doubles, for what needs no bound: the input of engines, lies of canaries, hints about adapters.
#pragma once

#include <Eigen/Geometry>

#include "model/frame.h"

namespace touchstone::oracle {

/// q/|q| for any q that is not zero, within a few ulps.
inline Eigen::Quaterniond rotation(const Quaternion& q) {
  return Eigen::Quaterniond(Eigen::Vector4d(q.x, q.y, q.z, q.w).stableNormalized());
}

/// The components of a rotation.
inline Quaternion quaternion(const Eigen::Quaterniond& R) { return {R.w(), R.x(), R.y(), R.z()}; }

}  // namespace touchstone::oracle
