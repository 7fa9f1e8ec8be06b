// The first scenes of a family, and how many of them are as it promises.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "properties/scenes/domain.h"

namespace touchstone::tests {

inline std::vector<Scene> drawn(const char* family, std::uint64_t draws) {
  std::vector<Scene> scenes;
  for (std::uint64_t i = 0; i < draws; ++i) scenes.push_back(properties::draw(properties::find_family(family), 5, i));
  return scenes;
}

template <class Is>
int count(const std::vector<Scene>& scenes, Is&& is) {
  return static_cast<int>(std::ranges::count_if(scenes, is));
}

}  // namespace touchstone::tests
