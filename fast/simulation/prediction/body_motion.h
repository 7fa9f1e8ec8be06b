// A body between two events: its properties and its trajectory.
#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "fast/broad_phase/strategy.h"
#include "fast/motion/ballistic_motion.h"
#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::fast::simulation {

/// Kinds of bodies with closed forms: a ball is a sphere about its centre of mass with three equal moments of inertia
/// (or a fixed sphere); a block is a fixed box that does not turn.
enum class Kind { ball, block, other };

/// The trajectory from `since` on: a point of the body moves along p + v τ + a τ²/2, τ = t − since; the angular
/// velocity of a ball is w + alpha τ. The point is the centre of mass of a body that moves, and the origin of a fixed
/// body.
struct Path {
  double since = 0;  ///< s
  Vec3 p = Vec3::Zero();
  Vec3 v = Vec3::Zero();
  Vec3 a = Vec3::Zero();
  Quaternion q;
  Vec3 w = Vec3::Zero();
  Vec3 alpha = Vec3::Zero();

  Vec3 place(double t) const {
    const double tau = t - since;
    return p + tau * (v + tau / 2 * a);
  }
  Vec3 velocity(double t) const { return v + (t - since) * a; }
};

class BodyMotion {
 public:
  /// Throws InputError if the shape is not a solid. The body must outlive this object.
  BodyMotion(const Body& body, double since, const Vec3& gravity);

  Kind kind() const { return kind_; }
  bool fixed() const { return fixed_; }
  double radius() const {
    return radius_;
  }  ///< of a ball; otherwise of a ball around the trajectory's point that
     ///< encloses the body
  double inverse_mass() const { return inverse_mass_; }
  double inverse_moment() const { return inverse_moment_; }  ///< of a ball
  const Body& body() const { return *body_; }
  const Material& material() const { return material_; }

  const Path& path() const { return path_; }

  /// The state at time t, as it is reported. A trajectory that restarts at t starts from exactly this state.
  State state(double t) const;

  /// Starts a new trajectory from the state, under the acceleration.
  void restart(double since, const State& state, const Vec3& acceleration, const Vec3& alpha = Vec3::Zero());

  /// Follows a contact step: like `restart`, but with a constant angular velocity, whatever the inertia.
  void follow_step(double since, const State& state, const Vec3& acceleration, const Vec3& spin);

  /// Whether by t the body has turned so far that doubles begin to lose its orientation (motion/steady_turn.h,
  /// motion/tumble.h), or that the power series of a ball's orientation becomes slow (prediction/spin.h).
  bool needs_restart(double t) const;
  /// Whether its orientation at t is determined at all: by doubles (motion/tumble.h), or by so many steps of the
  /// series.
  bool follows(double t) const;

  /// Encloses the body from `from` to `until` (≥ since), with `margin` added on each side.
  Aabb box(double from, double until, double margin) const;

  /// For queries without a closed form. A ball gets one without spin, since spin moves no point of its shape.
  const motion::BallisticMotion& ballistic() const;
  const motion::RigidBodyModel& model() const;

  const Mat3& R_WB() const { return block_->R_WB; }  ///< of a block only

 private:
  struct Block {
    Mat3 R_WB;
    Vec3 reach_lo, reach_hi;  ///< corners of its bounding box, relative to its origin
  };
  struct Other {
    explicit Other(const Body& body) : model(body) {}
    motion::RigidBodyModel model;
    std::optional<motion::RigidBodyModel> steady;  ///< the same with a constant angular velocity
    std::optional<motion::BallisticMotion> ballistic;
  };
  Other& other() const;
  void set_trajectory(double since, const State& state, const Vec3& acceleration, const Vec3& alpha);

  // Kept small for scenes of many balls: data that few kinds need is allocated apart, and data that time-of-impact
  // queries need comes first.
  double radius_ = 0;
  Kind kind_ = Kind::other;
  bool fixed_ = false, follows_step_ = false, axis_turns_ = false;
  Path path_;
  double inverse_mass_ = 0, inverse_moment_ = 0;
  Material material_;
  const Body* body_;
  std::unique_ptr<const Block> block_;
  mutable std::unique_ptr<Other> other_;
};

/// About the centre of mass, in B's axes; 0 for a fixed body.
Mat3 inertia(const BodyMotion& motion);
/// Whether its pose never changes.
inline bool is_stationary(const BodyMotion& motion) {
  const Path& path = motion.path();
  return path.v.isZero(0) && path.a.isZero(0) && (motion.kind() != Kind::other || path.w.isZero(0));
}
inline const Vec3& half_extents(const BodyMotion& block) { return std::get<Box>(block.body().shape).half_extents; }

}  // namespace touchstone::fast::simulation
