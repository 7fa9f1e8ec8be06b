// Islands: bodies connected by contacts, which take their steps together.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "fast/contact/step.h"
#include "fast/simulation/impact.h"

namespace touchstone::fast::world {

/// A body of an island: one that moves, or a fixed one that supports others.
struct IslandBody {
  BodyId id = 0;
  const BodyMotion* body = nullptr;
  contact::StepBody step_body;

  bool fixed() const { return body->fixed(); }
};

/// Two convex parts that touch or are near each other, with the contact points at which they touch.
struct ContactPair {
  BodyId a = 0, b = 0;  ///< a < b
  std::size_t part_a = 0, part_b = 0;
  Vec3 nhat_BA_W = Vec3::Zero();
  Vec3 p_WC = Vec3::Zero();  ///< of its first contact point
  std::vector<contact::ContactPoint> contact_points = {};
  bool emitted = false;  ///< its contact event has been emitted
  bool touched = false;  ///< has had a contact point; otherwise the pair is only near
};

/// A contact point at which the pair may collide.
struct ImpactCandidate {
  BodyId a = 0, b = 0;
  Touch touch;
  double u_n = 0;
};

class Island {
 public:
  /// Two parts touch up to a distance of `near`, and are kept as a contact pair up to a distance of `reach` (m).
  Island(double near, double reach) : near_(near), reach_(reach) {}

  /// Inserts a body in the order of ids. Requires that the island does not have it yet.
  void add(const IslandBody& island_body);
  /// Adds contact pairs for all parts of two of its bodies that are within reach. Returns whether the bodies have any.
  bool link(BodyId a, BodyId b);
  /// Adds, for bodies that have a contact pair, the pairs of parts that may come within reach in a step of h.
  void link_parts(double h);
  /// Adds the bodies and contact pairs of another island, which must be at the same time.
  void absorb(const Island& other);

  const std::vector<IslandBody>& bodies() const { return bodies_; }
  std::vector<ContactPair>& contact_pairs() { return contact_pairs_; }
  const std::vector<ContactPair>& contact_pairs() const { return contact_pairs_; }
  bool has(BodyId id) const;
  bool connects(BodyId a, BodyId b) const;
  BodyId key() const;  ///< the first of its bodies that move
  const State& state(BodyId id) const;
  /// Sets the velocity of a body. Its contacts may separate, so events for those that remain are emitted again.
  void set_velocity(BodyId id, const Velocity& velocity);
  void set_acceleration(BodyId id, const Vec3& acceleration);

  /// The states at `time` inside the current step, from a step of length `time - since`.
  std::vector<State> states_at(double time) const;
  /// Plans a step of h, or a shorter one that ends where the first corner not yet in contact comes down. Returns its
  /// length (s).
  double plan(double h);
  const contact::Stepped& planned_step() const { return plan_->stepped; }
  /// m; the greatest depth of two parts at the end of the planned step.
  double deepest() const;
  /// Advances to `time`: by the planned step or by a shorter one.
  void advance_to(double time);

  /// Recomputes the contact points. Releases a body when all its contacts separate faster than `release_speed(a, b)`
  /// (m/s) and none overlaps. Removes the contact pairs of released bodies, and returns those that have touched.
  std::vector<ContactPair> take_out_separating(const std::function<double(BodyId, BodyId)>& release_speed);
  /// The contact point that approaches fastest; none without contact points.
  std::optional<ImpactCandidate> fastest_approach() const;
  /// Counts an impact at the current time. Returns false if there have been so many at this time that each seems to
  /// cause the next.
  bool allows_impact();
  /// The islands of bodies that contact pairs connect. Bodies without a contact pair are left out.
  std::vector<Island> components() const;

  /// Removes the approach velocities at all contact points, without restitution.
  void remove_approach();
  /// Puts the island to sleep if no body is faster than `rest_speed` (m/s), the fixed ones do not move at all, and
  /// contact forces within the friction cones balance the applied accelerations: all velocities become 0. Returns
  /// whether it does.
  bool rest_test(double rest_speed);
  /// J; kinetic energy and potential energy in the applied accelerations.
  double energy() const;
  /// Sets and returns the longest step (s): one of `steps` while a body falls by its size, turns by a radian or moves
  /// by its size, and at most `most`.
  double step_length(double steps, double most);
  /// An estimate of how far bodies leave the trajectories with which the planned step is represented (m): parabolas and
  /// steady turns, although forces and angular velocities change within the step.
  double deviation() const;

  /// Marks the body's contact pairs, so that their contact events are emitted again.
  void emit_again(BodyId id);

  /// Makes the next steps shorter for a while, but not shorter than `least_share` of the longest step. Returns false if
  /// the current step is that short already, and true if there has been no step.
  bool shorten(double least_share);
  /// The speed at which bodies may leave their represented trajectories within the step (m/s), up to `margin`.
  double drift() const { return margin > 0 ? 2 * margin / (until - since) : 0; }

  double since = 0;        ///< s; the time of the states
  double longest = never;  ///< s; temporary upper bound of the next steps
  double margin = 0;       ///< m; `deviation` of the current step
  double until = 0;        ///< s; the end of the current step; never: the island sleeps
  bool waits = true;       ///< the next step has not begun

 private:
  void sort_contact_pairs();
  contact::StepBody& step_body(BodyId id);
  std::size_t index(BodyId id) const;
  std::vector<contact::StepBody> step_bodies() const;
  std::vector<contact::ContactConstraint> constraints() const;
  contact::Part part_of(BodyId id, std::size_t part, const State& state) const;
  bool update(ContactPair& contact_pair, double reach) const;
  void link(BodyId a, BodyId b, double reach);
  double speed_bound(BodyId id, double h) const;
  Vec3 normal(const ContactPair& contact_pair, const contact::Part& A, const State& at_a, const contact::Part& B,
              const State& at_b) const;
  ImpactCandidate candidate_at(const ContactPair& contact_pair, const contact::ContactPoint& contact_point) const;
  std::vector<double> clearances(const std::vector<State>& states) const;
  double clearance_left(const std::vector<double>& before, const std::vector<double>& after) const;

  struct Plan {
    double h = 0;
    contact::Stepped stepped;
    std::vector<contact::ContactConstraint> constraints;
  };
  Plan planned(double h) const;

  double near_, reach_;
  double last_impact_ = -never;     ///< s
  std::size_t impacts_now_ = 0;     ///< impacts at last_impact_
  std::vector<IslandBody> bodies_;  ///< sorted by id
  std::vector<ContactPair> contact_pairs_;
  std::optional<Plan> plan_;
  double step_length_ = 0;  ///< s; the longest step
};

}  // namespace touchstone::fast::world
