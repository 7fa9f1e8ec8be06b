// One body in free flight: where it is, how fast, and where it cannot be.
#pragma once

#include "fast/motion/flyer.h"
#include "fast/motion/tumble.h"
#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::fast::motion {

/// From where a pair is seen: O, near it, so that roundings are those of the pair's own lengths. O may fall from the
/// flight's start on, so that what both fall alike is not seen.
struct Origin {
  Vec3 p_WO = Vec3::Zero();  ///< m; at the start
  Vec3 a_WO = Vec3::Zero();  ///< m/s²
};

/// A centre of mass, as seen from O, and how far the exact one may be from it.
struct Centre {
  Vec3 p_WOBcm = Vec3::Zero();  ///< m
  Vec3 v_WBcm = Vec3::Zero();   ///< m/s; seen from O, too
  double error = 0;             ///< m
  double v_error = 0;           ///< m/s
};

/// Where a flight has brought its body, seen from O. For points p of the body,
/// |computed R (p − p_BBcm) + p_WOBcm − exact| ≤ turn_error |p − p_BBcm| + centre.error.
struct Stand {
  Centre centre;
  Quaternion q_WB;
  Mat3 R_WB = Mat3::Identity();
  Vec3 w_WB = Vec3::Zero();      ///< rad/s
  double turn_error = 0;         ///< rad; R's own rounding is in it
  double w_error = 0;            ///< rad/s
  Vec3 alpha_WB = Vec3::Zero();  ///< rad/s²; as exact as w_WB's square
};

/// What errors are counted against: the exact flight from its start; or the path that its doubles say, from one look at
/// it to the next, for whoever goes on from what is said. A tumble's errors grow against the first only.
enum class Against { exact, said };

/// A flight from a state at time `since`, as docs/design/simulation.md says: the centre of mass moves along
/// c(t) = c + v τ + a τ²/2, τ = t − since; the body turns free of torque about it. A fixed body's origin keeps its
/// velocity, its axes turn steadily. Times asked are not before `since`.
///
/// Only + − × ÷ and sqrt, in one order: the same bits everywhere. Not safe to share between threads: a tumbling body
/// remembers the steps that it has taken. Errors: docs/design/time_of_impact.md.
class Flight {
 public:
  /// `acceleration`: gravity, and push over mass, that within 64u; a fixed body has none, whatever is said. The flyer
  /// must outlive the flight.
  Flight(const Flyer& flyer, double since, const Pose& X_WB, const Velocity& velocity, const Vec3& acceleration,
         Against against = Against::exact);

  const Flyer& flyer() const { return *flyer_; }
  double since() const { return since_; }
  const Pose& start() const { return start_; }
  const Vec3& acceleration() const { return acceleration_; }

  /// At `since` itself: the very doubles that the flight was made from.
  State state(double t) const;
  Pose pose(double t) const { return state(t).X_WB; }
  Velocity velocity(double t) const { return state(t).velocity; }

  /// Whether what is said at t is a flight's turning at all (tumble.h).
  bool follows(double t) const;

  Centre centre(double t, const Origin& O = {}) const;
  Stand stand(double t, const Origin& O = {}) const;

  /// ≥ |ω(t)| at all times (rad/s), and least so up to rounding: Ω² = 2T(1/I₁ + 1/I₃) − L²/(I₁ I₃).
  double rate() const { return rate_; }
  /// ≥ |p̈ − acceleration| / |p − p_BBcm| for all points p of the body, at all times (rad²/s²).
  double curl() const { return curl_; }

  /// ≥ the length of the third derivative of p / |p − p_BBcm|, likewise (rad³/s³).
  double whirl() const { return whirl_; }

  /// Holds the body at all times of [from, until], also if from `from` on an unknown force of at most `greatest_force`
  /// (N) acts on it anywhere: the parabola with its apex, and around it the ball about the centre of mass; of a body
  /// that does not turn, its tight box instead. Rounded outward.
  Aabb box(double from, double until, double greatest_force = 0) const;

 private:
  bool turns() const { return rate_ > 0; }

  const Flyer* flyer_;
  Turning turning_;
  Against against_;
  double since_;
  Pose start_;
  Velocity velocity_;
  Vec3 acceleration_;
  Vec3 p_BBcm_W_;  ///< at `since`
  double rate_ = 0;
  double curl_ = 0;
  double whirl_ = 0;
  mutable Tumble tumble_;  ///< of a tumbling body
};

}  // namespace touchstone::fast::motion
