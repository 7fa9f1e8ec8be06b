// Impacts in the form that engines take: rigid bodies in axes at their centres of mass, restitution by one law.
#pragma once

#include <numbers>
#include <optional>

#include "oracle/subjects/common/engine.h"

namespace touchstone::oracle::subjects {

/// The pose of the centre of mass, in the body's axes. A body with a density has it at its origin, as for spheres and
/// boxes.
inline Pose centre_of_mass(const Body& body) {
  Pose X = body.X_WB;
  const auto* given = std::get_if<MassProperties>(&body.mass);
  if (given != nullptr) X.p_WB += rotation(X.q_WB) * given->p_BBcm;
  return X;
}

/// Volume (m³) of a sphere or a box: engines take a mass and leave its computation from a density to their users.
inline double volume(const Shape& shape) {
  if (const auto* sphere = std::get_if<Sphere>(&shape)) {
    return 4.0 / 3 * std::numbers::pi * sphere->radius * sphere->radius * sphere->radius;
  }
  return 8 * std::get<Box>(shape).half_extents.prod();
}

/// Why an engine with one law of restitution and static ground cannot be asked about the scene; none if it can.
inline std::optional<Abstains> no_such_impact(const Scene& scene, Law law = Law::newton) {
  if (!scene.contact) return Abstains{"no contact"};
  if (scene.contact->law != law) return Abstains{"this impact law is not offered"};
  for (const Body& body : scene.bodies) {
    if (is_fixed(body) && !(body.velocity == Velocity{})) return Abstains{"moving fixed bodies are not offered"};
    const bool weighed = std::holds_alternative<Sphere>(body.shape) || std::holds_alternative<Box>(body.shape);
    if (std::holds_alternative<Density>(body.mass) && !weighed) return Abstains{"the mass of hulls is not computed"};
  }
  return std::nullopt;
}

}  // namespace touchstone::oracle::subjects
