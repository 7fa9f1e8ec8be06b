// A body between two events: what it is, and the path that it is on.
#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "fast/broad_phase/strategy.h"
#include "fast/motion/flight.h"
#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::fast::world {

/// Bodies for which closed forms do: a ball is a sphere about its centre of mass with one moment of inertia (or a fixed
/// sphere), a block a fixed box that does not turn.
enum class Kind { ball, block, other };

/// The path from `since` on: its point moves along p + v τ + a τ²/2, τ = t − since; a ball's ω along w + alpha τ.
/// Of a body that is not fixed the point is its centre of mass, else its origin.
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

class Mover {
 public:
  /// Throws InputError where the shape is no solid. The body must outlive the mover.
  Mover(const Body& body, double since, const Vec3& gravity);

  Kind kind() const { return kind_; }
  bool fixed() const { return fixed_; }
  double radius() const { return radius_; }  ///< of a ball; else of a ball around the path's point that holds the body
  double inverse_mass() const { return inverse_mass_; }
  double inverse_moment() const { return inverse_moment_; }  ///< of a ball
  Mat3 inertia() const;                                      ///< about the centre of mass, in B's axes
  const Body& body() const { return *body_; }
  const Material& material() const { return material_; }

  const Path& path() const { return path_; }
  bool still() const;  ///< its path stays where it is

  /// Where its path has brought it, as it is reported: what is flown from, if the body sets out anew at t.
  State state(double t) const;

  /// Sets out anew: from the state, under the acceleration.
  void fly(double since, const State& state, const Vec3& acceleration, const Vec3& alpha = Vec3::Zero());

  /// Moves on as a step in contact says: as fly, but with a spin that stays, whatever its inertia.
  void glide(double since, const State& state, const Vec3& acceleration, const Vec3& spin);

  /// Whether by t it has turned so far that doubles begin to lose how it is turned (steady_turn.h, tumble.h).
  bool tires(double t) const;
  bool follows(double t) const;  ///< doubles tell at all how it is turned at t (motion/tumble.h)

  /// Holds the body from `from` to `until` (≥ since), and `margin` more on each side.
  Aabb box(double from, double until, double margin) const;

  /// For questions without a closed form. Of a ball, one that does not spin: that moves none of its points elsewhere.
  const motion::Flight& flight() const;
  const motion::Flyer& flyer() const;

  /// Of a block.
  const Mat3& R_WB() const { return block_->R_WB; }
  const Vec3& half_extents() const { return std::get<Box>(body_->shape).half_extents; }

 private:
  struct Block {
    Mat3 R_WB;
    Vec3 reach_lo, reach_hi;  ///< of its box, from its origin
  };
  struct Other {
    explicit Other(const Body& body) : flyer(body) {}
    motion::Flyer flyer;
    std::optional<motion::Flyer> steady;  ///< the same, but its spin stays
    std::optional<motion::Flight> flight;
  };
  Other& other() const;
  void set_out(double since, const State& state, const Vec3& acceleration, const Vec3& alpha);

  // Many balls are many of these: what only few kinds need stands elsewhere, and what meetings need stands first.
  double radius_ = 0;
  Kind kind_ = Kind::other;
  bool fixed_ = false, glides_ = false;
  Path path_;
  double inverse_mass_ = 0, inverse_moment_ = 0;
  Material material_;
  const Body* body_;
  std::unique_ptr<const Block> block_;
  mutable std::unique_ptr<Other> other_;
};

}  // namespace touchstone::fast::world
