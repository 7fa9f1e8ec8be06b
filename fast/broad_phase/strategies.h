// All strategies by name.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fast/broad_phase/strategy.h"

namespace touchstone::fast {

struct Strategy {
  std::string name;
  std::string says;  ///< a description in one line
  std::function<std::unique_ptr<BroadPhase>()> make;
};

/// In the order of the lecture notes; the default comes last.
const std::vector<Strategy>& strategies();

/// Throws InputError that lists the known names.
const Strategy& find_strategy(const std::string& name);

}  // namespace touchstone::fast
