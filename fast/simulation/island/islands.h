// All islands of a simulation, and which of them each body is in.
#pragma once

#include <map>

#include "fast/simulation/island/island.h"
#include "fast/simulation/world.h"

namespace touchstone::fast::simulation {

/// A body that moves is in one island at most. A fixed one is in none, although islands contain copies of it.
class Islands {
 public:
  /// The world must outlive the islands.
  explicit Islands(const World& world) : world_(&world), island_of_(world.bodies().size()) {}

  /// Null: the body is in no island.
  Island* of(BodyId id) { return island_of_[id] ? &islands_.at(*island_of_[id]) : nullptr; }
  const Island* of(BodyId id) const { return island_of_[id] ? &islands_.at(*island_of_[id]) : nullptr; }
  /// Whether the body moves by contact steps, or is a fixed one.
  bool follows_steps(BodyId id) const { return world_->body(id).fixed() || island_of_[id]; }
  /// Where the body is at the current time. Requires that its island, if it has one, has been advanced to it.
  State state(BodyId id) const;

  /// None of its bodies that move may be in an island.
  void insert(Island island);
  /// Removes the island that the body is in, and returns it.
  Island take(BodyId id);

  /// Sorted by the first of their bodies that move.
  const std::map<BodyId, Island>& all() const { return islands_; }
  /// The first island whose next step has not begun.
  const Island* next_waiting() const;
  /// The island whose step ends first; the first of several.
  const Island* first_to_finish() const;

 private:
  const World* world_;
  std::map<BodyId, Island> islands_;              ///< keyed by the first of its bodies that move
  std::vector<std::optional<BodyId>> island_of_;  ///< indexed by body: the key of its island
};

}  // namespace touchstone::fast::simulation
