// Bodies connected by contacts: a graph whose edges are contact pairs.
#pragma once

#include <functional>
#include <optional>

#include "fast/simulation/island/contact_pair.h"

namespace touchstone::fast::simulation {

class ContactGraph {
 public:
  /// Two parts touch up to a distance of `near`, and are kept as a contact pair up to a distance of `reach` (m).
  ContactGraph(double near, double reach) : near_(near), reach_(reach) {}

  /// Inserts a body in the order of ids. Requires that the graph does not have it yet.
  void add(const IslandBody& island_body);
  /// Adds contact pairs for all parts of two of its bodies that are within reach. Returns whether the bodies have any.
  bool link(BodyId a, BodyId b);
  /// Adds, for bodies that have a contact pair, the pairs of parts that may come within reach in a step of h.
  void link_parts(double h);
  /// Adds the bodies and contact pairs of another graph, which must be at the same time, and takes over the greater
  /// distances.
  void absorb(const ContactGraph& other);
  /// The graphs of bodies that contact pairs connect through bodies that move. Bodies without a contact pair are left
  /// out.
  std::vector<ContactGraph> components() const;

  double near() const { return near_; }
  const std::vector<IslandBody>& bodies() const { return bodies_; }  ///< sorted by id
  const std::vector<ContactPair>& contact_pairs() const { return contact_pairs_; }
  std::vector<ContactPair>& contact_pairs() { return contact_pairs_; }
  bool has(BodyId id) const;
  bool connects(BodyId a, BodyId b) const;
  BodyId key() const;                  ///< the first of its bodies that move
  std::size_t index(BodyId id) const;  ///< in `bodies`
  IslandBody& body(std::size_t index) { return bodies_[index]; }
  const State& state(BodyId id) const { return bodies_[index(id)].state(); }

  /// Recomputes the contact points. Releases a body when all its contacts separate faster than `release_speed(a, b)`
  /// (m/s) and none overlaps. A body that has not touched yet stays while it is near one in contact that moves. Removes
  /// the contact pairs of released bodies, and returns those that have touched.
  std::vector<ContactPair> take_out_separating(const std::function<double(BodyId, BodyId)>& release_speed);
  /// The contact points of each contact pair that has any, at the bodies' current states.
  std::vector<PairPoints> points() const;
  /// Marks the body's contact pairs, so that their contact events are emitted again.
  void emit_again(BodyId id);

 private:
  void link(BodyId a, BodyId b, double reach);

  double near_, reach_;
  std::vector<IslandBody> bodies_;
  std::vector<BodyId> ids_;  ///< of `bodies_`: searched more often than all else
  std::vector<ContactPair> contact_pairs_;
};

/// The contact point that approaches fastest, and the first one of several; none without contact points.
std::optional<ImpactCandidate> fastest_approach(const std::vector<PairPoints>& contacts);

}  // namespace touchstone::fast::simulation
