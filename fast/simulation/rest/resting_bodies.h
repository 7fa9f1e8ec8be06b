// The bodies that rest on others in closed form.
#pragma once

#include "fast/simulation/rest/resting_contact.h"

namespace touchstone::fast::simulation {

class RestingBodies {
 public:
  explicit RestingBodies(std::size_t bodies) : rest_(bodies) {}

  /// Null: the body does not rest.
  const RestingContact* of(BodyId id) const { return rest_[id] ? &*rest_[id] : nullptr; }
  bool rests_on(BodyId id, BodyId on) const { return rest_[id] && rest_[id]->on == on; }
  void set(BodyId id, const RestingContact& rest) { rest_[id] = rest; }
  void erase(BodyId id) { rest_[id].reset(); }

 private:
  std::vector<std::optional<RestingContact>> rest_;  ///< indexed by body
};

}  // namespace touchstone::fast::simulation
