// Balls that rotation leaves where they are.
#pragma once

#include <variant>

#include "model/scene.h"

namespace touchstone::properties {

/// Is it a ball whose centre of mass is its centre? A fixed one turns about its centre too.
inline bool is_central_ball(const Body& body) {
  const auto* given = std::get_if<MassProperties>(&body.mass);
  return std::holds_alternative<Sphere>(body.shape) && (given == nullptr || given->p_BBcm.isZero(0));
}

}  // namespace touchstone::properties
