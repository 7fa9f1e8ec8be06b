// How far a careful computation of a flight may be from it, derived in tolerance_motion.cpp.
#pragma once

#include <array>
#include <cstddef>

#include "model/scene.h"
#include "oracle/impact.h"
#include "oracle/subject.h"

namespace touchstone::oracle::tolerance {

/// Of one body, some time after its flight began.
struct FlightBound {
  double place = 0;     ///< m: of any of its points, and of its origin
  double velocity = 0;  ///< m/s: of v_WBcm
  double spin = 0;      ///< rad/s: of w_WB
  double fastest = 0;   ///< m/s; of any of its points, to rounding: no bound on an error
  double farthest = 0;  ///< m; of any of its points from W's origin, likewise
};

/// Flown from its `since` (else 0) to `time`, under the last push that began by then. Requires a completed scene with a
/// flight, and time ≥ since.
FlightBound flight(const Scene& scene, std::size_t body, double time, Precision precision);

/// rad: of a body's turn free of torque over so many seconds, at rates that never exceed `rate` (rad/s).
double turn(const Scene& scene, std::size_t body, double rate, double seconds, Precision precision);

/// m: of the distance of bodies 0 and 1 at a computed time up to `time`.
double meeting(const Scene& scene, double time, Precision precision);

/// √J: what errors of the velocities before an impact make of those after.
double impact_in_flight(const Impact& impact, const std::array<FlightBound, 2>& before);

/// 1: sin of the angle by which a normal may be off that was taken from witness points `apart` (m) from each other.
double normal(const Scene& scene, double apart, Precision precision);

/// 1: what a sum over the bodies gathers by rounding, in u times its greatest terms, over so many events.
double gathered(std::size_t events, std::size_t bodies);

/// Roundings of a stepping engine that reports no events: so many steps are granted to it.
inline constexpr std::size_t steps = 1 << 14;

}  // namespace touchstone::oracle::tolerance
