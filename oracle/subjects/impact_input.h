// Impacts as engines take them: rigid bodies about their centres of mass, restitution by Newton's law.
#pragma once

#include <optional>

#include "oracle/subjects/engine.h"

namespace touchstone::oracle::subjects {

/// The pose of the centre of mass, in the body's axes. Of a body of a density: its origin, as for spheres and boxes.
inline Pose centre_of_mass(const Body& body) {
  Pose X = body.X_WB;
  const auto* given = std::get_if<MassProperties>(&body.mass);
  if (given != nullptr) X.p_WB += unit_quaternion(X.q_WB) * given->p_BBcm;
  return X;
}

inline bool is_fixed(const Body& body) { return std::holds_alternative<Fixed>(body.mass); }

/// What engines of Newton's law and static ground do not offer; none: the scene can be asked.
inline std::optional<Abstains> no_such_impact(const Scene& scene) {
  if (!scene.contact) return Abstains{"no contact"};
  if (scene.contact->law != Law::newton) return Abstains{"restores by Newton's law alone"};
  for (const Body& body : scene.bodies) {
    if (is_fixed(body) && !(body.velocity == Velocity{})) return Abstains{"static bodies do not move"};
    const bool weighed = std::holds_alternative<Sphere>(body.shape) || std::holds_alternative<Box>(body.shape);
    if (std::holds_alternative<Density>(body.mass) && !weighed) return Abstains{"computes the mass of no hull"};
  }
  return std::nullopt;
}

}  // namespace touchstone::oracle::subjects
