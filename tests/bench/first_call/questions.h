// The questions that `fast` and the exact reference are asked once.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/scene.h"

namespace touchstone::bench {

/// A query, and the two functions that answer it. Both return whether they answered the whole question; false and any
/// exception leave the scene out.
struct Asked {
  std::string query;
  std::function<bool(const Scene&)> fast, reference;
};

/// All queries of oracle/query.h, in its order.
const std::vector<Asked>& asked_queries();

/// Scenes with something in common.
struct Questions {
  std::string name;
  std::vector<Scene> scenes;
};

/// `count` scenes of each drawn family of the query (properties/scenes/domain.h), then of larger shapes or more bodies
/// where the families have small ones. A pure function of its arguments.
std::vector<Questions> questions(const std::string& query, int count);

}  // namespace touchstone::bench
