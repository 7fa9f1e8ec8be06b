#include "fast/simulation/island/islands.h"

namespace touchstone::fast::simulation {

State Islands::state(BodyId id) const {
  const Island* island = of(id);
  return island ? island->graph().state(id) : world_->body(id).state(world_->now());
}

void Islands::insert(Island island) {
  const BodyId key = island.graph().key();
  for (const IslandBody& island_body : island.graph().bodies()) {
    if (!island_body.fixed()) island_of_[island_body.id] = key;
  }
  islands_.insert_or_assign(key, std::move(island));
}

Island Islands::take(BodyId id) {
  Island island = std::move(islands_.extract(*island_of_[id]).mapped());
  for (const IslandBody& island_body : island.graph().bodies()) island_of_[island_body.id].reset();
  return island;
}

const Island* Islands::next_waiting() const {
  for (const auto& [key, island] : islands_) {
    if (island.waits()) return &island;
  }
  return nullptr;
}

const Island* Islands::first_to_finish() const {
  const Island* first = nullptr;
  for (const auto& [key, island] : islands_) {
    if (!island.waits() && (!first || island.until() < first->until())) first = &island;
  }
  return first;
}

}  // namespace touchstone::fast::simulation
