#include "properties/cases/restitution.h"

#include <algorithm>

#include "properties/cases/central_ball.h"

namespace touchstone::properties {

bool restitution_may_add_energy(const Scene& scene) {
  const auto rebound_and_rub = [](const Body& a, const Body& b) {
    return std::min(a.material.restitution, b.material.restitution) > 0 &&
           std::min(a.material.friction, b.material.friction) > 0;
  };
  const auto off_centre = [](const Body& body) { return !is_fixed(body) && !is_central_ball(body); };
  for (const Body& a : scene.bodies) {
    for (const Body& b : scene.bodies) {
      if (&a != &b && off_centre(a) && rebound_and_rub(a, b)) return true;
    }
  }
  return false;
}

}  // namespace touchstone::properties
