// Ballistic motion of one rigid body: its states, their errors, and boxes that it does not leave.
#pragma once

#include "fast/motion/rigid_body_model.h"
#include "fast/motion/tumble.h"
#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::fast::motion {

/// The point O relative to which a pair is computed, near the pair, so that rounding is relative to the pair's own
/// lengths. O may accelerate from the motion's start on, so that a common acceleration of both bodies cancels.
struct Origin {
  Vec3 p_WO = Vec3::Zero();  ///< m; at the start
  Vec3 a_WO = Vec3::Zero();  ///< m/s²
};

/// A centre of mass, relative to O, and how far the exact one may be from it.
struct Centre {
  Vec3 p_WOBcm = Vec3::Zero();  ///< m
  Vec3 v_WBcm = Vec3::Zero();   ///< m/s; relative to O
  double error = 0;             ///< m
  double v_error = 0;           ///< m/s
};

/// The kinematics of a body relative to O at some time. For points p of the body, |computed R (p − p_BBcm) + p_WOBcm −
/// exact| ≤ turn_error |p − p_BBcm| + centre.error.
struct Kinematics {
  Centre centre;
  Quaternion q_WB;
  Mat3 R_WB = Mat3::Identity();
  Vec3 w_WB = Vec3::Zero();      ///< rad/s
  double turn_error = 0;         ///< rad; includes R's own rounding
  double w_error = 0;            ///< rad/s
  Vec3 alpha_WB = Vec3::Zero();  ///< rad/s²; as exact as the square of w_WB
};

/// What errors are measured against. `exact`: the exact motion from its start. `computed`: the computed path from one
/// evaluation to the next, for callers that continue from computed states. A tumble's errors grow only against `exact`.
enum class Against { exact, computed };

/// The torque-free motion from a state at time `since`, as docs/design/simulation.md says: the centre of mass moves
/// along c(t) = c + v τ + a τ²/2, τ = t − since, and the body rotates about it without torque. A fixed body's origin
/// keeps its velocity, and its axes rotate steadily. Times must not be before `since`.
///
/// Uses only + − × ÷ and sqrt, in one order: the same bits everywhere. Not safe to share between threads: a tumbling
/// body remembers the integration steps that it has taken. Errors: docs/design/time_of_impact.md.
class BallisticMotion {
 public:
  /// `acceleration`: gravity, plus force over mass, the latter within 64u; ignored for a fixed body. The model must
  /// outlive the motion.
  BallisticMotion(const RigidBodyModel& model, double since, const Pose& X_WB, const Velocity& velocity,
                  const Vec3& acceleration, Against against = Against::exact);

  const RigidBodyModel& model() const { return *model_; }
  double since() const { return since_; }
  const Pose& start() const { return start_; }
  const Vec3& acceleration() const { return acceleration_; }

  /// At `since` itself: exactly the doubles that the motion was made from.
  State state(double t) const;
  Pose pose(double t) const { return state(t).X_WB; }
  Velocity velocity(double t) const { return state(t).velocity; }

  /// Whether the rotation computed at t follows the body's own at all (tumble.h).
  bool follows(double t) const;

  Centre centre(double t, const Origin& O = {}) const;
  Kinematics kinematics(double t, const Origin& O = {}) const;

  /// ≥ |ω(t)| at all times (rad/s), and the least such bound up to rounding: Ω² = 2T(1/I₁ + 1/I₃) − L²/(I₁ I₃).
  double rate() const { return rate_; }
  /// ≥ |p̈ − acceleration| / |p − p_BBcm| for all points p of the body, at all times (rad²/s²).
  double acceleration_per_radius() const { return acceleration_per_radius_; }

  /// ≥ |p⃛| / |p − p_BBcm| for all points p of the body, at all times (rad³/s³).
  double jerk_per_radius() const { return jerk_per_radius_; }

  /// Contains the body at all times in [from, until], even if from `from` on an unknown force of at most
  /// `greatest_force` (N) acts on it at any point. It is the box of the parabola, its apex included, extended by the
  /// ball about the centre of mass, or by the body's tight box if it does not rotate. Rounded outward.
  Aabb box(double from, double until, double greatest_force = 0) const;

 private:
  bool turns() const { return rate_ > 0; }

  const RigidBodyModel* model_;
  Turning turning_;
  Against against_;
  double since_;
  Pose start_;
  Velocity velocity_;
  Vec3 acceleration_;
  Vec3 p_BBcm_W_;  ///< at `since`
  double rate_ = 0;
  double acceleration_per_radius_ = 0;
  double jerk_per_radius_ = 0;
  mutable Tumble tumble_;  ///< of a tumbling body
};

}  // namespace touchstone::fast::motion
