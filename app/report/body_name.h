// The name of a body in messages.
#pragma once

#include <fmt/format.h>

#include <string>

#include "model/scene.h"

namespace touchstone::app {

/// "bodies[3]", or "bodies[3] (cue)" if it has a name.
inline std::string body_name(const Scene& scene, int i) {
  const std::string& name = scene.bodies[static_cast<std::size_t>(i)].name;
  return name.empty() ? fmt::format("bodies[{}]", i) : fmt::format("bodies[{}] ({})", i, name);
}

}  // namespace touchstone::app
