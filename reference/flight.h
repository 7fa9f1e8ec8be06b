// Where a body in flight is, and how fast: enclosures that hold the exact motion of docs/design/simulation.md.
#pragma once

#include <array>
#include <cstddef>

#include "model/scene.h"

namespace touchstone::reference {

/// Each interval holds the exact value at one time; W's axes.
struct FlightTruth {
  std::array<Interval, 3> p_WB;                 ///< B's origin (m)
  std::array<Interval, 4> q_WB;                 ///< w, x, y, z of a quaternion of R_WB, not of length 1
  std::array<std::array<Interval, 3>, 3> R_WB;  ///< rows
  std::array<Interval, 3> v_WBcm;               ///< m/s; of a fixed body its origin's, as in the scene
  std::array<Interval, 3> w_WB;                 ///< rad/s
};

/// Of a body that flies alone from its `since` (else 0) to `time`, pushed by the last push that began by then.
///
/// Requires a completed scene with a flight. Throws InputError if `time` is before the body's start, if a push of the
/// body begins between the two (its motion then has more than one piece), or if a given inertia is not positive
/// definite exactly.
/// Error: enclosed; an end is within some ulps of the exact value, as long as it is known at all.
/// Gives up: of a tumbling body (three different moments of inertia) nothing is known where its motion is within some
/// 2^-100 of a principal axis, or of the one that ends at the middle axis, without being it: its intervals are infinite.
/// Cost: 0.1 ms; 1.3 ms for a tumbling body, however far it has turned.
FlightTruth flown(const Scene& scene, std::size_t body, double time);

}  // namespace touchstone::reference
