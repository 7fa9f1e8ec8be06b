// The pose and velocity of a body in ballistic motion: enclosures of the exact motion of docs/design/simulation.md.
#pragma once

#include <array>
#include <cstddef>

#include "model/scene.h"

namespace touchstone::reference {

/// Each interval holds the exact value at one time, in W's axes.
struct BallisticTruth {
  std::array<Interval, 3> p_WB;                 ///< B's origin (m)
  std::array<Interval, 4> q_WB;                 ///< w, x, y, z of a quaternion of R_WB, not of length 1
  std::array<std::array<Interval, 3>, 3> R_WB;  ///< rows
  std::array<Interval, 3> v_WBcm;               ///< m/s; for a fixed body the velocity of its origin, as in the scene
  std::array<Interval, 3> w_WB;                 ///< rad/s
};

/// The state at `time` of a body that moves alone from its start time (0 if none is given), under the last applied
/// force that begins by then.
///
/// Requires a completed scene with a motion. Throws InputError if `time` is before the body's start, if an applied
/// force of the body begins between the two (the motion then has more than one piece), or if a given inertia is not
/// positive definite exactly.
/// Error: enclosed; where the value is known, each end is within some ulps of it.
/// Gives up: a tumbling body (three different moments of inertia) has infinite intervals where its motion is within
/// some 2^-100 of the motion that ends at the middle axis, without being it; and where it is that near to a rotation
/// about a principal axis, once it may be 2^-64 off that, which takes many turns.
/// Cost: 0.1 ms; 1.3 ms for a tumbling body, however far it has turned.
BallisticTruth ballistic_state(const Scene& scene, std::size_t body, double time);

}  // namespace touchstone::reference
