// One body in free flight: where it is, how fast, and where it cannot be.
#pragma once

#include <vector>

#include "fast/motion/flyer.h"
#include "fast/motion/tumble.h"
#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::fast::motion {

/// Where a flight has brought its body, and how far from the exact motion that may be: for points p of the body,
/// |computed R (p − p_BBcm) + p_WBcm − exact| ≤ turn_error |p − p_BBcm| + shift_error.
struct Stand {
  Mat3 R_WB = Mat3::Identity();
  Vec3 p_WBcm = Vec3::Zero();
  Vec3 w_WB = Vec3::Zero();    ///< rad/s
  Vec3 v_WBcm = Vec3::Zero();  ///< m/s
  double turn_error = 0;       ///< rad
  double shift_error = 0;      ///< m
};

/// A flight from a state at time `since`, as docs/design/simulation.md says: the centre of mass moves along
/// c(t) = c + v τ + a τ²/2, τ = t − since; the body turns free of torque about it. A fixed body's origin keeps its
/// velocity, its axes turn steadily. Times asked are not before `since`.
///
/// Only + − × ÷ and sqrt, in one order: the same bits everywhere. Not safe to share between threads: a tumbling body
/// remembers the steps that it has taken.
class Flight {
 public:
  /// `acceleration`: gravity and push over mass; 0 is used for a fixed body. The flyer must outlive the flight.
  Flight(const Flyer& flyer, double since, const Pose& X_WB, const Velocity& velocity, const Vec3& acceleration);

  const Flyer& flyer() const { return *flyer_; }
  double since() const { return since_; }
  const Vec3& acceleration() const { return acceleration_; }

  /// At `since` itself: the very doubles that the flight was made from.
  State state(double t) const;
  Pose pose(double t) const { return state(t).X_WB; }
  Velocity velocity(double t) const { return state(t).velocity; }

  Stand stand(double t) const;

  /// ≥ |ω(t)| at all times (rad/s), and least so up to rounding: Ω² = 2T(1/I₁ + 1/I₃) − L²/(I₁ I₃).
  double rate() const { return rate_; }
  /// ≥ |p̈ − acceleration| / |p − p_BBcm| for all points p of the body, at all times (rad²/s²).
  double curl() const { return curl_; }

  /// Holds the body at all times of [from, until], both ≥ since, also if from `from` on an unknown force of at most
  /// `greatest_force` (N) acts on it anywhere: the parabola with its apex, and around it the ball about the centre of
  /// mass, or, where the body does not turn, its tight box. Rounded outward.
  Aabb box(double from, double until, double greatest_force = 0) const;

 private:
  const Flyer* flyer_;
  double since_;
  Pose start_;
  Velocity velocity_;
  Vec3 acceleration_;
  Vec3 p_WBcm_;
  double rate_ = 0;
  double curl_ = 0;
  mutable Tumble tumble_;  ///< of a tumbling body
};

}  // namespace touchstone::fast::motion
