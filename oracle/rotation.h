// Rotations in plain doubles, for what needs no bound: lies of canaries, hints about adapters.
#pragma once

#include <Eigen/Geometry>

#include "model/frame.h"

namespace touchstone::oracle {

/// The rotation of q/|q|, within a few ulps. Requires a q whose norm neither overflows nor underflows.
inline Eigen::Quaterniond rotation(const Quaternion& q) { return Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized(); }

inline Quaternion quaternion(const Eigen::Quaterniond& R) { return {R.w(), R.x(), R.y(), R.z()}; }

}  // namespace touchstone::oracle
