// A contestant in the comparison of times of impact.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/answers.h"
#include "model/scene.h"

namespace touchstone::bench {

/// Asks about one pair again; what may be kept from one call to the next was prepared when the pair entered.
using Ask = std::function<TimeOfImpact()>;

struct Entrant {
  std::string name;
  std::string whose;  ///< "ours"; "peer": ours is compared with it
  std::function<Ask(const Scene&)> enter;
};

/// On bodies that are prepared: with motions that are prepared too, and with new ones, as after an impact.
std::vector<Entrant> ours();
/// fast::time_of_impact_of and reference::time_of_impact of a scene: they keep nothing.
std::vector<Entrant> asked_once();
/// btContinuousConvexCollision, on shapes that are prepared.
std::vector<Entrant> bullet();
/// fcl::continuousCollide by conservative advancement, on geometries that are prepared.
std::vector<Entrant> fcl();

}  // namespace touchstone::bench
