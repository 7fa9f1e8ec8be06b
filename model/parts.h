// The parts of a body: those of its compound, or the one that it is.
#pragma once

#include <cstddef>
#include <variant>

#include "model/scene.h"

namespace touchstone {

/// The number of parts: 1 for a body whose shape is no compound.
inline int part_count(const Body& body) {
  const auto* compound = std::get_if<Compound>(&body.shape);
  return compound == nullptr ? 1 : static_cast<int>(compound->parts.size());
}

/// The body with one of its parts alone. The part's pose is kept as it is: composed poses would be rounded.
inline Body part_alone(const Body& body, int part) {
  const auto* compound = std::get_if<Compound>(&body.shape);
  if (compound == nullptr) return body;
  Body alone = body;
  alone.shape = Compound{{compound->parts.at(static_cast<std::size_t>(part))}};
  return alone;
}

}  // namespace touchstone
