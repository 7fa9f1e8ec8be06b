// Error bounds of a careful computation of a ballistic motion, derived in oracle/tolerance/motion.cpp.
#pragma once

#include <array>
#include <cstddef>

#include "model/scene.h"
#include "oracle/subject.h"
#include "oracle/truth/impact.h"

namespace touchstone::oracle::tolerance {

/// For one body, some time after its ballistic motion began.
struct BallisticBound {
  double place = 0;     ///< m: of any of its points, and of its origin
  double velocity = 0;  ///< m/s: of v_WBcm
  double spin = 0;      ///< rad/s: of w_WB
  double fastest = 0;   ///< m/s: speed of its fastest point, to rounding; not an error bound
  double farthest = 0;  ///< m: greatest distance of its points from W's origin, likewise
};

/// From the body's start time (0 if none is given) to `time`, under the last applied force that begins by then.
/// Requires a completed scene with a motion, and a time not before the start.
BallisticBound ballistic(const Scene& scene, std::size_t body, double time, Precision precision);

/// What rounding a state to the precision takes, be it exact before.
BallisticBound rounded_state(const Scene& scene, std::size_t body, double time, Precision precision);

/// What a time-stepping method as declared may add to that, derived in docs/design/stepping.md; `fastest` and
/// `farthest` stay 0.
BallisticBound stepped(const Scene& scene, std::size_t body, double time, const Stepping& stepping,
                       Precision precision);

/// 1: what the steps until `time` round off a speed, relative to its greatest value.
double rounding_of_steps(double time, const Stepping& stepping, Precision precision);

/// m/s: the greatest speed of a point of a body at the start.
double fastest_at_start(const Scene& scene);

/// m: the longest way of a point of a body in so many seconds without impacts.
double longest_way(const Scene& scene, double seconds);

/// m: how far two bodies may move towards each other in one step, before the stepper notices that they touch.
double way_of_step(const Scene& scene, double step);

/// m: how far errors `off` of a body's state at `time` move its points until `until`.
double carried(const Scene& scene, std::size_t body, double time, double until, const BallisticBound& off);

/// rad: error of a body's torque-free rotation over `seconds`, at rates that never exceed `rate` (rad/s).
double turn(const Scene& scene, std::size_t body, double rate, double seconds, Precision precision);

/// m: error of the distance of bodies 0 and 1 at a computed time up to `time`.
double moving_distance(const Scene& scene, double time, Precision precision);

/// m: by how much two bodies may be apart, or overlap, at a time of impact, as the subject declares.
double granted(const Scene& scene, const ContactTolerance& declared);

/// m/s: error of the relative velocity at C before an impact; `arms` (m) bounds the errors of p_BcmC_W of A and B.
double at_contact(const Impact& impact, const std::array<BallisticBound, 2>& before, const std::array<double, 2>& arms);

/// A ball that leaves a fixed plane at the speed v, pressed by g_n, bounces for 2v/(g_n (1 − e)).
struct Bounces {
  Real speed = 0;    ///< m/s: v
  Real speeds = 0;   ///< m/s: of all points of the ball, before and after, as far from its centre as the origin is
  Real presses = 0;  ///< m/s²: g_n
  Real gravity = 0;  ///< m/s²: |g|
  double restitution = 0;

  Real seconds() const { return 2 * speed / (presses * (1 - Real{restitution})); }
};

/// s: error of the computed time `end` at which they end.
double end_of_bounces(const Bounces& bounces, double end, Precision precision);

/// √J: effect of the same errors on the velocities after an impact.
double through_impact(const Scene& scene, const Impact& impact, const std::array<BallisticBound, 2>& before,
                      const std::array<double, 2>& arms);

/// 1: sin of the angle error of a normal from witness points at a distance `apart` (m).
double normal(const Scene& scene, double apart, Precision precision);

/// 1: accumulated rounding of a sum over the bodies after so many events, in u times its greatest terms.
double accumulated(std::size_t events, std::size_t bodies);

/// The number of steps whose rounding is granted to a stepping engine that reports no events. A choice: shorter steps
/// would add rounding without making a trajectory of some seconds better.
inline constexpr std::size_t steps = 1 << 14;

}  // namespace touchstone::oracle::tolerance
