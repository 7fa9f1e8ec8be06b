// Two convex parts of bodies in contact, with the contact points at which they touch.
#pragma once

#include <optional>
#include <span>

#include "fast/contact/step.h"
#include "fast/simulation/impact.h"

namespace touchstone::fast::simulation {

/// A body of an island: one that moves, or a fixed one that supports others.
struct IslandBody {
  BodyId id = 0;
  const BodyMotion* body = nullptr;
  contact::StepBody step_body;

  bool fixed() const { return body->fixed(); }
  const State& state() const { return step_body.state; }
};

/// An upper bound of the speed of any of its points within h (m/s), without contact forces.
double speed_bound(const IslandBody& island_body, double h);

/// Two convex parts that touch or are near each other, with the contact points at which they touch.
struct ContactPair {
  BodyId a = 0, b = 0;  ///< a < b
  std::size_t part_a = 0, part_b = 0;
  Vec3 nhat_BA_W = Vec3::Zero();
  Vec3 p_WC = Vec3::Zero();  ///< of its first contact point
  std::vector<contact::ContactPoint> contact_points = {};
  /// A contact point of other parts of the two bodies, whose normal is this pair's too; see shared_normal.h.
  std::optional<contact::ContactPoint> shared = {};
  bool emitted = false;  ///< its contact event has been emitted
  bool touched = false;  ///< has had a contact point; otherwise the pair is only near

  bool has(BodyId id) const { return a == id || b == id; }
};

/// A contact point at which the pair may collide.
struct ImpactCandidate {
  BodyId a = 0, b = 0;
  Touch touch;
  double u_n = 0;
};

/// The contact points of two convex parts, or of two bodies that touch in one point. All have one normal.
using PairPoints = std::vector<ImpactCandidate>;

/// A part of a body in a given state.
contact::Part part_of(const IslandBody& island_body, std::size_t part, const State& state);

/// Whether a normal separates parts that are so far apart along it: they may overlap by a quarter of `near` (m).
inline bool separates(double apart, double near) { return apart >= -near / 4; }

/// The contact points along n of parts that are at most `near` (m) apart along it. If they overlap a little, all
/// corners in the overlap are contact points.
std::vector<contact::ContactPoint> points_along(const contact::Part& A, const contact::Part& B, const Vec3& n,
                                                double near);

/// Recomputes the normal and the contact points from the current states of A and B. Parts touch up to a distance of
/// `near` (m). Returns false, and leaves the contact points as they are, if they are farther apart than `reach` (m).
///
/// The normal is that of the first contact point's features, if the pair has contact points, since the bodies have not
/// moved far. If it says that the parts overlap, other features may separate them by now, as when the end of an edge
/// hangs over the side of a face: then all normals of the separating-axis theorem are tested.
///
/// It is not the pair's last word: shared_normal.h follows.
bool update(ContactPair& contact_pair, const IslandBody& A, const IslandBody& B, double near, double reach);

/// For two parts that come together and share no normal with others: if many normals separate them, gives the pair the
/// one of approach_normal.h at the middle of its contact points, with the contact points along it.
void choose_normal_of_approach(ContactPair& contact_pair, const IslandBody& A, const IslandBody& B, double near);

/// The contact point at the current states of A and B.
ImpactCandidate candidate_at(const ContactPair& contact_pair, const contact::ContactPoint& contact_point,
                             const IslandBody& A, const IslandBody& B);

/// How far the two parts are apart (m), 0 if they overlap, with A and B in the given states.
double distance(const ContactPair& contact_pair, const IslandBody& A, const State& at_a, const IslandBody& B,
                const State& at_b);

/// Whether the two parts press in a step with these constraints, and are farther apart than `within` (m) after it, with
/// A and B in the given states, because no contact point that presses is on both any more. Features are planes and
/// lines without ends, so a gap of 0 does not tell.
bool have_come_apart(const ContactPair& contact_pair, std::span<const contact::ContactConstraint> constraints,
                     const IslandBody& A, const State& at_a, const IslandBody& B, const State& at_b, double within);

/// The separations of all vertices of both parts along the pair's normal (m), with A and B in the given states.
std::vector<double> clearances(const ContactPair& contact_pair, const IslandBody& A, const State& at_a,
                               const IslandBody& B, const State& at_b, double near);

/// How fast these change at the current states of A and B (m/s), where no other vertex becomes the extreme one.
std::vector<double> clearance_rates(const ContactPair& contact_pair, const IslandBody& A, const IslandBody& B);

}  // namespace touchstone::fast::simulation
