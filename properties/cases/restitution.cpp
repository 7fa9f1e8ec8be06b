#include "properties/cases/restitution.h"

#include <algorithm>

namespace touchstone::properties {
namespace {

bool is_central_ball(const Body& body) {
  const auto* given = std::get_if<MassProperties>(&body.mass);
  return std::holds_alternative<Sphere>(body.shape) && (given == nullptr || given->p_BBcm.isZero(0));
}

}  // namespace

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
